group-rrp = two links, two pins and an outer slide; with a crank: rod and piston of a slider-crank
    .ways = 1: the inner pin ahead of the foot of the outer pin, in the direction of the guide; 2: behind it
    .singular = the rod perpendicular to the guide
    .angle = pressure angle of the rod to the guide
    .source = S stage 2; theory of circle and line
group-rrp-no-rod = the rod of a group RRP needs its two pins apart; their distance is 0
# Remarks of the working.
rrp-working-offset = distance of { $pin } to the left of the guide line
rrp-working-distances = PF0: distance δ of { $pin } from { $a } across the guide, σ along it;
rrp-working-ahead = { $pin } is ahead of the foot, in the direction of the guide: sign +
rrp-working-behind = { $pin } is behind the foot: sign -
rrp-working-fixed-guide = PF1: across the guide on { $carrier }, { $pin } does not move
rrp-working-moving-guide = PF1: across the guide on { $carrier }, { $pin } moves like the point of { $carrier } that coincides with it, with V
rrp-working-normal-part = PF2: normal component n of { $pin } about { $a }
rrp-working-normal-and-coriolis = PF2: normal component n of { $pin } about { $a }; { $relative } along the guide, Coriolis component { $coriolis } across it
rrp-working-coriolis = cor
rrp-working-moments = along the guide { $slider } transmits its load to { $pin }; moments about { $a } give the component across
rrp-working-forces = forces on each link, then moments on the sliding link about its point on the guide:
