# What quantities belong to.
owner-link = link { $name }
owner-point = point { $name }
owner-slide = slide { $name }
owner-pair-on = { $name } on { $link }
owner-group = group { $number }
owner-load = load { $name }

# Quantities.
quantity-time = time
quantity-coordinate = coordinate
quantity-speed = input speed
quantity-input-acceleration = input acceleration
quantity-work-driving = work of the driving loads
quantity-work-resisting = work of the resisting loads
quantity-kinetic-energy = kinetic energy
quantity-pf0 = PF0
quantity-pf1 = PF1
quantity-pf2 = PF2
quantity-velocity = velocity
quantity-acceleration = acceleration
quantity-reduced-inertia = reduced inertia
quantity-reduced-inertia-derivative = derivative of the reduced inertia
quantity-reduced-moment = reduced moment
quantity-inertia-force = inertia force
quantity-inertia-moment = inertia moment
quantity-shaking-force = shaking force
quantity-shaking-moment = shaking moment
quantity-force = force
quantity-moment = moment
quantity-offset = offset of the force
quantity-balancing = balancing load
quantity-holding = holding load
quantity-holding-bound = greatest holding load
quantity-condition = condition
quantity-residual-test-pf = residual of TestPf
quantity-residual-equilibrium = residual of equilibrium
quantity-residual-dynamics = residual of the equation of motion
quantity-residual-global = residual of the global check
# How facts stand in a table.
fact-quantity = Quantity
fact-value = Value
fact-unit = Unit
fact-place = At
fact-range = { $least } to { $most }
