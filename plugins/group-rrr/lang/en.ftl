group-rrr = two links, three pins; with a crank: coupler and rocker of a four-bar
    .ways = 1: the inner pin left of the line from the outer pin of the first link to that of the second; 2: right
    .singular = the links in one line, stretched or folded: sin(phi2 - phi1) = 0
    .angle = transmission angle between the links
    .source = S stage 2; theory of two circles
group-rrr-no-link = link { $link } of a group RRR needs its two pins apart; their distance is 0
# Remarks of the working.
rrr-working-circles = PF0: circles about { $a } and { $b }. The foot of { $pin } on { $a }-{ $b } is at the fraction α of { $a }-{ $b } from { $a };
rrr-working-left = the height of { $pin } is the fraction β of { $a }-{ $b }, left of the line from { $a } to { $b }: sign +
rrr-working-right = the height of { $pin } is the fraction β of { $a }-{ $b }, right of the line from { $a } to { $b }: sign -
rrr-working-loop = PF1: { $a1 } + { $phi1 } × ({ $a }-{ $pin }) equals { $b1 } + { $phi2 } × ({ $b }-{ $pin });
rrr-working-determinant = two equations for both φ′, with the determinant D:
rrr-working-normal-parts = PF2: the same equations with the normal components n of { $pin } about { $a } and about { $b } added
rrr-working-moments = the moments about { $a } and about { $b } contain only the reaction in { $pin }; the determinant is D again
