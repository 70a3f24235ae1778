structure-group = group { $number } ({ $kind } { $links })
    .short = group { $number }
structure-links-named = { $count ->
        [one] link
       *[other] links
    } { $links }
structure-pairs = { $count ->
        [one] pair
       *[other] pairs
    } { $pairs }
structure-some = { $names } ... ({ $shown } of { $total } shown)
structure-loose = mobility { $mobility } ({ $formula }), but one input moves the mechanism: { $links } can still move while the input is fixed{ $also }; join { $count ->
        [one] it
       *[other] them
    } to another link by one more pair, or remove what is loose there ({ $hint })
structure-loose-also = {" "}(while the pairs { $pairs } have one constraint too many)
structure-more-inputs = the mechanism has { $mobility } degrees of freedom ({ $formula }), so it takes { $mobility } inputs and has { $inputs }. With these fixed { $links } can still move: give the others as entries of `[[input]]`, or take these freedoms away by a pair more or a link fewer
structure-dependent-input = input `{ $input }`: what it drives is already determined by the inputs before it; the mechanism has { $mobility } degrees of freedom ({ $formula }) and { $inputs } inputs. Leave this input out, or drive another pair
structure-surplus = mobility { $mobility } ({ $formula }), must be { $inputs }: { $pairs } { $count ->
        [one] gives
       *[other] give
    } one constraint too many on { $links }; remove one pair or one link there ({ structure-what-joins }: points that are not pins need names of their own){ $block }{ $cause }
structure-missing-block = ; if a pin is meant to move along a slot of `{ $on }`, its slide block is missing: a link of its own that is pinned to `{ $link }`{ $at } and slides on `{ $on }`
structure-at-point = {" "}at `{ $point }`
structure-no-plugin = { $links } form a group of class { $class }, order { $order } ({ $pattern }); no plugin is registered for it (see `assur plugins`; another input link may give other groups)
structure-pattern = inner { $inner }; outer { $outer }
structure-what-joins = a point name used in two links makes a pin there
structure-alike = the points `{ $one }` and `{ $other }` occur in one link each and have similar names: one name in both links makes a pin there
structure-slide-angles = the angle of slide `{ $slide }` differs by { $off } from what the other slides require, so no position satisfies them all; a link whose x axis does not lie along its guide needs a `tilt`, here `tilt = "{ $tilt }"`
structure-slide-on-pinned = nothing is left to move in slide `{ $slide }`: pin `{ $pin }` joins the same two links
structure-alone = a point name used in two links makes a pin there; these points are in one link only: { $points }
structure-passive-link = link { $link }
structure-passive-pair = pair { $pair } of { $link }
