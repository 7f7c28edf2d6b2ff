# The braking path of an axis.

braking-path = The braking path is { $sum } mm: { $delay } mm until the command to brake, { $braking } mm while braking, { $following } mm of following error.
braking-feed = Largest feed for this deflection: { $feed } mm/min.
braking-value = { $name } = { $value } is not possible: enter a positive number.
