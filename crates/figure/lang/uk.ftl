# Рисунки.
figure-gap = зазор
