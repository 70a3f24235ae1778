# Remarks of the working.
rrr-working-circles = PF0: circles about { $a } and { $b }. The foot of { $pin } on { $a }-{ $b } is at the fraction α of { $a }-{ $b } from { $a };
rrr-working-left = the height of { $pin } is the fraction β of { $a }-{ $b }, left of the line from { $a } to { $b }: sign +
rrr-working-right = the height of { $pin } is the fraction β of { $a }-{ $b }, right of the line from { $a } to { $b }: sign -
rrr-working-loop = PF1: { $a1 } + { $phi1 } × ({ $a }-{ $pin }) equals { $b1 } + { $phi2 } × ({ $b }-{ $pin });
rrr-working-determinant = two equations for both φ′, with the determinant D:
rrr-working-normal-parts = PF2: the same equations with the normal parts n of { $pin } about { $a } and about { $b } added
rrr-working-moments = the moments about { $a } and about { $b } contain only the reaction in { $pin }; the determinant is D again
