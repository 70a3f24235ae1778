# What the workings of all groups share.
worksheet-between-arguments = {", "}
worksheet-working = Working
worksheet-fixed = fixed
worksheet-from-to = from { $from } to { $to }, along the { $axis } axis of { $link }
worksheet-length = length { $from }-{ $to }
worksheet-guide-angle = angle of the guide on { $link }
worksheet-tilt = angle of { $link } from the guide
worksheet-outer-pin = outer pin { $pin }: PF0 { $pf0 }, PF1 { $pf1 }, PF2 { $pf2 }
worksheet-carrier = link with the guide: { $link }, angle { $pf0 }, PF1 { $pf1 }, PF2 { $pf2 }
worksheet-carrier-at-rest = link with the guide: { $link }, at rest
worksheet-forces-on-links = forces on each link:
