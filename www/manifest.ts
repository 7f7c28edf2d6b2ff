// What a system needs to install the page as a program: names, icons, ways in, and the files that it opens.
import type { ManifestOptions } from "vite-plugin-pwa";
import { GROUND } from "./icons";

const png = (size: number, purpose: "any" | "maskable" = "any") => ({
  src: `icon-${purpose === "any" ? "" : `${purpose}-`}${size}.png`,
  sizes: `${size}x${size}`,
  type: "image/png",
  purpose,
});

const shortcut = (name: string, place: string) => ({
  name,
  url: `./#start=${place}`,
  icons: [png(192)],
});

// A type of our own: text/plain would offer the page for every text. Each file gets a window of its own, none takes the
// place of work that is open.
const FILES = {
  action: "./",
  accept: { "application/x-nc-program": [".mpf", ".spf", ".nc"] },
  launch_type: "multiple-clients",
};

/** The system fixes the language of these words when it installs the page, so they are in one. */
export const manifest: Partial<ManifestOptions> = {
  name: "Probewright",
  short_name: "Probewright",
  description: "Programming assistant for CNC measuring cycles: form, program, simulated measurement and result.",
  lang: "en",
  start_url: "./",
  scope: "./",
  display: "standalone",
  background_color: "#eceff1",
  theme_color: GROUND,
  categories: ["productivity", "utilities"],
  icons: [
    png(192),
    png(512),
    png(512, "maskable"),
    { src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" },
  ],
  // `src/page/launch.ts`
  shortcuts: [shortcut("Start a form", "tasks"), shortcut("Open a program", "program"), shortcut("Search", "search")],
  file_handlers: [FILES],
};
