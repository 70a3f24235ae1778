group-rpp = two links, an outer pin, a slide between them and an outer slide; with a crank: stone and ram of a Scotch yoke
    .ways = one
    .singular = the guides parallel
    .angle = angle between the guides
    .source = S stage 2; theory of two lines
# Remarks of the working.
rpp-working-offset = distance of { $point } to the left of { $a }, across the inner guide
rpp-working-position = PF0: { $point } is on the outer guide and keeps its distance from { $a } across the inner one
rpp-working-angles = the links can't turn against the body with the outer guide: all angles are known
rpp-working-first = PF1: seen from { $carrier }, { $a } moves with v, and { $point } with u along the outer guide
rpp-working-second = PF2: the same with the accelerations a and c
rpp-working-second-with-coriolis = PF2: the same with the accelerations a and c, without and with the Coriolis component 2 φ′ × (v, u)
rpp-working-transmitted = along the outer guide { $link } transmits its load to the inner one
rpp-working-moments = moments about { $a } give the moment in the inner guide
rpp-working-rest = the rest is carried by the outer guide
