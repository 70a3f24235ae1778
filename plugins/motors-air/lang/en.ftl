motors-air = series AIR, 0.37-30 kW, 2-8 poles; no rotor inertia
    .source = textbook table of the series; list of the maker Polesyeelectromash
