# Общее для расчётов всех групп.
worksheet-between-arguments = {"; "}
worksheet-working = Расчёт
worksheet-fixed = неподвижна
worksheet-from-to = от { $from } до { $to }, вдоль оси { $axis } звена «{ $link }»
worksheet-length = длина { $from }-{ $to }
worksheet-guide-angle = угол направляющей на звене «{ $link }»
worksheet-tilt = угол звена «{ $link }» от направляющей
worksheet-outer-pin = внешний шарнир { $pin }: ПФ0 { $pf0 }, ПФ1 { $pf1 }, ПФ2 { $pf2 }
worksheet-carrier = звено с направляющей: { $link }, угол { $pf0 }, ПФ1 { $pf1 }, ПФ2 { $pf2 }
worksheet-carrier-at-rest = звено с направляющей: { $link }, неподвижно
worksheet-forces-on-links = силы на каждое звено:
