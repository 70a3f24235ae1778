# Figures.
figure-gap = gap
