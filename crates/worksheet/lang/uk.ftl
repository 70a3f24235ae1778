# Спільне для розрахунків усіх груп.
worksheet-between-arguments = {"; "}
worksheet-working = Розрахунок
worksheet-fixed = нерухома
worksheet-from-to = від { $from } до { $to }, уздовж осі { $axis } ланки «{ $link }»
worksheet-length = довжина { $from }-{ $to }
worksheet-guide-angle = кут напрямної на ланці «{ $link }»
worksheet-tilt = кут ланки «{ $link }» від напрямної
worksheet-outer-pin = зовнішній шарнір { $pin }: ПФ0 { $pf0 }, ПФ1 { $pf1 }, ПФ2 { $pf2 }
worksheet-carrier = ланка з напрямною: { $link }, кут { $pf0 }, ПФ1 { $pf1 }, ПФ2 { $pf2 }
worksheet-carrier-at-rest = ланка з напрямною: { $link }, нерухома
worksheet-forces-on-links = сили на кожну ланку:
