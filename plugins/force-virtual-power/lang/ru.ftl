force-virtual-power = уравновешивающая нагрузка по мощностям всех нагрузок (рычаг Жуковского); без реакций
    .source = принцип виртуальных мощностей; рычаг Жуковского
    .wording = по балансу мощностей (рычаг Жуковского)
force-lever-title = Рычаг Жуковского: план скоростей для dq = 1, повёрнутый по часовой стрелке
force-lever-image = скорость точки { $point } для dq = 1, повёрнутая
force-lever-contact = скорость точки контакта ({ $what }) для dq = 1, повёрнутая
force-lever-link = звено `{ $link }` между изображениями его точек
force-lever-at = { $what }, в изображении точки приложения
force-lever-couple = момент { $couple } ({ $what }) парой сил поперёк линии двух точек звена: сила в точке { $point }; в неподвижной точке её нет
force-lever-index = ур
force-lever-balancing-load = уравновешивающая нагрузка на входном звене
force-lever-balancing-force = уравновешивающая сила
force-lever-balancing-moment = уравновешивающий момент
