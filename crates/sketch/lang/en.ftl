sketch-free-link = free link
    .about = a link that nothing holds yet: three freedoms more
sketch-rod = rod between two points
    .about = one link, two pins: one freedom less
sketch-block = block in a slot
    .about = one link that slides: one freedom more
sketch-turns = { $link } turns on { $on } about { $pin }
sketch-slides = { $link } slides on { $on }
sketch-no-place = point { $name } has no place yet: nothing tells where its links are
sketch-no-pose = nothing tells where link { $name } is: join it to others, or give a point of it in [assembly]
sketch-no-link = there is no link { $name }
sketch-no-point = there is no point { $name }
sketch-no-slide = there is no slide { $name }
sketch-not-on-link = point { $name } is no point of link { $link }
sketch-wants-guide = outer pair { $number } is a slide: give a link and a line on it
sketch-wants-point = outer pair { $number } is a pin: give a point, or a link and a place
sketch-targets = for { $needed } outer { $needed ->
        [one] pair
       *[other] pairs
    } as many targets are needed, given: { $given }
sketch-same-point = two pins of one link can't both be at point { $name }
sketch-link-taken = a link is named { $name } already, or it can't be: choose another name
sketch-point-taken = a point or slide is named { $name } already: choose another name
