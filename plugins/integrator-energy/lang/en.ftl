integrator-energy = energy form: speed from the work, quadrature in the coordinate; M(q) only
    .source = E eq. 1
integrator-energy-suits = the work along the coordinate gives the speed by one quadrature, without steps in time
integrator-energy-unfit = the energy form needs a moment that depends on the coordinate alone, and here it is case { $case } of D: { $equation }
integrator-energy-creeps = creeps into an equilibrium without end
