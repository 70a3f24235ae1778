integrator-closed-form = J and M constant: uniformly accelerated motion, exact
    .source = D 3.12, 3.13
integrator-closed-form-suits = uniformly accelerated motion has a closed form, exact
integrator-closed-form-unfit = the closed form needs J and M constant (case 1 of D), and here it is case { $case }: { $equation }
integrator-quadrature = J constant, M(t) or M(w): speed and displacement by quadrature over time, time and displacement by quadrature over the speed
    .source = D 3.21, case 2
integrator-quadrature-unfit = the quadrature needs J constant and M constant, M(t) or M(w) (cases 1 and 2 of D), and here it is case { $case }: { $equation }
integrator-quadrature-over-speed = t = J * integral of dw / M(w) gives the motion by one quadrature over the speed
integrator-quadrature-over-time = the impulse of the moment gives the speed by one quadrature over time
integrator-quadrature-too-fine = no polynomial in the speed follows the moment near w = { $speed } (t = { $time } s) to this tolerance; a method in steps of time does
integrator-quadrature-settles = settles at a speed, which it approaches without end
