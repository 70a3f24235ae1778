force-friction = група за групою із сухим тертям у парах, усі розв’язки
    .source = Артоболевський, Теорія механізмів і машин, тертя в кінематичних парах; Ortega, Rheinboldt 1970, 13.1
force-friction-balance = зрівноважувальне навантаження з `[balance]`
force-friction-input = вхідна ланка
