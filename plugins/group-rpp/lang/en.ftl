group-rpp = two links, an outer pin, a slide between them and an outer slide
    .ways = one
    .singular = the guides parallel
    .angle = angle between the guides
    .source = S stage 2; theory of two lines
