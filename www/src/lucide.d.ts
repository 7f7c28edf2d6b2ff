// The package types its list of all icons only.

declare module "lucide/dist/esm/icons/*.mjs" {
  const parts: [tag: string, attributes: Record<string, string | number>][];
  export default parts;
}
