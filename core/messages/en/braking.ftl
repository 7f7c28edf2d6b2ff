# The braking path of an axis.

braking-path = The braking path is { $sum } mm: { $delay } mm until the command to brake, { $braking } mm while braking, { $following } mm of following error.
braking-feed = Largest feed for this deflection: { $feed } mm/min.
braking-value =
    { $name ->
        [delay] The delay
        [acceleration] The deceleration
        [gain] The servo gain
        [feed] The feed
       *[deflection] The deflection
    } cannot be { $value }: enter a number { $name ->
        [delay] of 0 or more
       *[other] above 0
    }.
