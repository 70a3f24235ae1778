force-virtual-power = balancing load from the powers of all loads (Zhukovsky's lever); no reactions
    .source = principle of virtual power; Zhukovsky's lever
force-lever-title = Zhukovsky's lever: velocity plan for dq = 1, turned by a right angle clockwise
force-lever-loads = the loads of `{ $link }`
force-lever-image = velocity of { $point } for dq = 1, turned
force-lever-on-line = { $what }, in the image of a point of their line of action
force-lever-first = moment { $couple } of { $what }, the first of two forces 1 m apart
force-lever-second = moment { $couple } of { $what }, the second of two forces 1 m apart
force-lever-couple = { $name } couple { $number }
force-lever-balance = balance
force-lever-balancing-load = the balancing load on the input link
force-lever-balancing-force = the balancing force
force-lever-balancing-moment = the balancing moment
