# Чему принадлежат величины.
owner-link = звено { $name }
owner-point = точка { $name }
owner-slide = ползун { $name }
owner-pair-on = { $name } на { $link }
owner-group = группа { $number }
owner-load = нагрузка { $name }

# Величины.
quantity-time = время
quantity-coordinate = координата
quantity-speed = скорость входного звена
quantity-input-acceleration = ускорение входного звена
quantity-work-driving = работа движущих нагрузок
quantity-work-resisting = работа нагрузок сопротивления
quantity-kinetic-energy = кинетическая энергия
quantity-pf0 = PF0
quantity-pf1 = PF1
quantity-pf2 = PF2
quantity-velocity = скорость
quantity-acceleration = ускорение
quantity-reduced-inertia = приведённый момент инерции
quantity-reduced-inertia-derivative = производная приведённого момента инерции
quantity-reduced-moment = приведённый момент
quantity-inertia-force = сила инерции
quantity-inertia-moment = момент сил инерции
quantity-shaking-force = сила на фундамент
quantity-shaking-moment = момент на фундамент
quantity-force = сила
quantity-moment = момент
quantity-offset = смещение силы
quantity-balancing = уравновешивающая нагрузка
quantity-holding = удерживающая нагрузка
quantity-holding-bound = наибольшая удерживающая нагрузка
quantity-condition = обусловленность
quantity-residual-test-pf = невязка TestPf
quantity-residual-equilibrium = невязка равновесия
quantity-residual-dynamics = невязка уравнения движения
quantity-residual-global = невязка глобальной проверки
# Как величины стоят в таблице.
fact-quantity = Величина
fact-value = Значение
fact-unit = Единица
fact-place = Где
fact-range = от { $least } до { $most }
