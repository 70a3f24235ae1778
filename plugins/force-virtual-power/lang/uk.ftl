force-virtual-power = зрівноважувальне навантаження за потужностями всіх навантажень (важіль Жуковського); без реакцій
    .source = принцип можливих потужностей; важіль Жуковського
force-lever-title = Важіль Жуковського: план швидкостей для dq = 1, повернутий на прямий кут за годинниковою стрілкою
force-lever-loads = навантаження ланки `{ $link }`
force-lever-image = швидкість точки { $point } для dq = 1, повернута
force-lever-on-line = { $what }, в образі точки їхньої лінії дії
force-lever-first = момент { $couple } ({ $what }), перша з двох сил на відстані 1 м
force-lever-second = момент { $couple } ({ $what }), друга з двох сил на відстані 1 м
force-lever-couple = { $name } пара { $number }
force-lever-balance = урівноваження
force-lever-balancing-load = зрівноважувальне навантаження на вхідній ланці
force-lever-balancing-force = зрівноважувальна сила
force-lever-balancing-moment = зрівноважувальний момент
