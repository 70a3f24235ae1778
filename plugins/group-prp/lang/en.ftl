group-prp = two links that slide on outer bodies and share a pin
    .ways = one
    .singular = the guides parallel
    .angle = angle between the guides
    .source = S stage 2; theory of two lines
# Remarks of the working.
prp-working-offset = distance of { $pin } to the left of guide { $guide }
prp-working-intersection = PF0: { $pin } is the intersection of two lines along the guides; D is the sine of their angle
prp-working-first = PF1: across each guide { $pin } moves like the point of the guiding link that coincides with it, with V
prp-working-second = PF2: the same with W, and the Coriolis components { $one }, { $two } where a guide rotates
prp-working-coriolis = cor
prp-working-transmitted = along its guide each link transmits its load to { $pin }
prp-working-rest = the rest is carried by the guides: normal forces N, and moments about the points on the guides
