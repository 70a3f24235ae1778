group-rrp = two links, two pins and an outer slide
    .ways = 0: the inner pin ahead of the foot of the outer pin, in the direction of the guide; 1: behind it
    .singular = the rod perpendicular to the guide
    .angle = pressure angle of the rod to the guide
    .source = S stage 2; theory of circle and line
group-rrp-no-rod = the rod of a group RRP needs its two pins apart; their distance is 0
