force-virtual-power = зрівноважувальне навантаження за потужностями всіх навантажень (важіль Жуковського); без реакцій
    .source = принцип віртуальних потужностей; важіль Жуковського
force-lever-title = Важіль Жуковського: план швидкостей для dq = 1, повернутий за годинниковою стрілкою
force-lever-image = швидкість точки { $point } для dq = 1, повернута
force-lever-contact = швидкість точки контакту ({ $what }) для dq = 1, повернута
force-lever-link = ланка `{ $link }` між зображеннями її точок
force-lever-at = { $what }, у зображенні точки прикладання
force-lever-couple = момент { $couple } ({ $what }) парою сил упоперек лінії двох точок ланки: сила в точці { $point }; у нерухомій точці її немає
force-lever-balance = Fзр
force-lever-balancing-load = зрівноважувальне навантаження на вхідній ланці
force-lever-balancing-force = зрівноважувальна сила
force-lever-balancing-moment = зрівноважувальний момент
