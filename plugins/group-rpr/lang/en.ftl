group-rpr = two links with outer pins and a slide between them; with a crank: stone and rocker, or cylinder and rod
    .ways = 1: the outer pin of the first link ahead of that of the second, in the direction of the guide; 2: behind it
    .singular = the distance of the outer pins equal to the offset of the guide (zero for a central guide)
    .angle = pressure angle of the line of the pins to the guide
    .source = S stage 2; theory of the right triangle
# Remarks of the working.
rpr-working-offset = distance of { $a } to the left of { $b }, across the guide
rpr-working-components = PF0: d from { $b } to { $a } has the components e across and s along the guide;
rpr-working-ahead = { $a } lies ahead of { $b } in the direction t of the guide: sign +
rpr-working-behind = { $a } lies behind { $b } in the direction t of the guide: sign -
rpr-working-first = PF1: both links rotate equally; the component of d′ across the guide is s φ′, along it s′ - e φ′
rpr-working-second = PF2: with the Coriolis component 2 s′ φ′
rpr-working-moments = the moments of both links about their outer pins contain only the normal force N; its arm is s
