group-rrr = two links, three pins
    .ways = 0: the inner pin left of the line from the outer pin of the first link to that of the second; 1: right
    .singular = the links in one line, stretched or folded: sin(phi2 - phi1) = 0
    .angle = transmission angle between the links
    .source = S stage 2; theory of two circles
group-rrr-no-link = link { $link } of a group RRR needs its two pins apart; their distance is 0
