force-virtual-power = balancing load from the powers of all loads (Zhukovsky's lever); no reactions
    .source = principle of virtual power; Zhukovsky's lever
    .wording = by the balance of powers (Zhukovsky's lever)
force-lever-title = Zhukovsky's lever: velocity plan for dq = 1, turned clockwise
force-lever-image = velocity of { $point } for dq = 1, turned
force-lever-contact = velocity of the point of contact ({ $what }) for dq = 1, turned
force-lever-link = the link `{ $link }` between the images of its points
force-lever-at = { $what }, in the image of the point where it acts
force-lever-couple = moment { $couple } ({ $what }) as a couple of forces across the line of two points of the link: the one at { $point }; at a point at rest there is none
force-lever-index = bal
force-lever-balancing-load = the balancing load on the input link
force-lever-balancing-force = the balancing force
force-lever-balancing-moment = the balancing moment
