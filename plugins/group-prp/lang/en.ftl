group-prp = two links that slide on outer bodies and share a pin
    .ways = one
    .singular = the guides parallel
    .angle = angle between the guides
    .source = S stage 2; theory of two lines
