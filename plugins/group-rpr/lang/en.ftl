group-rpr = two links with outer pins and a slide between them
    .ways = 0: the outer pin of the first link ahead of that of the second, in the direction of the guide; 1: behind it
    .singular = the distance of the outer pins equal to the offset of the guide (zero for a central guide)
    .angle = pressure angle of the line of the pins to the guide
    .source = S stage 2; theory of the right triangle
