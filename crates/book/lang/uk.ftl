# Чому належать величини.
owner-link = ланка { $name }
owner-point = точка { $name }
owner-slide = повзун { $name }
owner-pair-on = { $name } на { $link }
owner-group = група { $number }
owner-load = навантаження { $name }

# Величини.
quantity-time = час
quantity-coordinate = координата
quantity-speed = швидкість вхідної ланки
quantity-input-acceleration = прискорення вхідної ланки
quantity-work-driving = робота рушійних навантажень
quantity-work-resisting = робота навантажень опору
quantity-kinetic-energy = кінетична енергія
quantity-pf0 = PF0
quantity-pf1 = PF1
quantity-pf2 = PF2
quantity-velocity = швидкість
quantity-acceleration = прискорення
quantity-reduced-inertia = зведений момент інерції
quantity-reduced-inertia-derivative = похідна зведеного моменту інерції
quantity-reduced-moment = зведений момент
quantity-inertia-force = сила інерції
quantity-inertia-moment = момент сил інерції
quantity-shaking-force = сила на фундамент
quantity-shaking-moment = момент на фундамент
quantity-force = сила
quantity-moment = момент
quantity-offset = зміщення сили
quantity-balancing = зрівноважувальне навантаження
quantity-holding = утримувальне навантаження
quantity-holding-bound = найбільше утримувальне навантаження
quantity-condition = обумовленість
quantity-residual-test-pf = нев'язка TestPf
quantity-residual-equilibrium = нев'язка рівноваги
quantity-residual-dynamics = нев'язка рівняння руху
quantity-residual-global = нев'язка глобальної перевірки
# Як величини стоять у таблиці.
fact-quantity = Величина
fact-value = Значення
fact-unit = Одиниця
fact-place = Де
fact-range = від { $least } до { $most }
