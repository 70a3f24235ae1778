force-virtual-power = уравновешивающая нагрузка по мощностям всех нагрузок (рычаг Жуковского); без реакций
    .source = принцип возможных мощностей; рычаг Жуковского
force-lever-title = Рычаг Жуковского: план скоростей для dq = 1, повёрнутый на прямой угол по часовой стрелке
force-lever-loads = нагрузки звена `{ $link }`
force-lever-image = скорость точки { $point } для dq = 1, повёрнутая
force-lever-on-line = { $what }, в образе точки их линии действия
force-lever-first = момент { $couple } ({ $what }), первая из двух сил на расстоянии 1 м
force-lever-second = момент { $couple } ({ $what }), вторая из двух сил на расстоянии 1 м
force-lever-couple = { $name } пара { $number }
force-lever-balance = уравновешивание
force-lever-balancing-load = уравновешивающая нагрузка на входном звене
force-lever-balancing-force = уравновешивающая сила
force-lever-balancing-moment = уравновешивающий момент
