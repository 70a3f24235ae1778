# Figures.
figure-gap = gap
figure-dxf-planes = DXF has no plots over axes: draw a plane (mechanism, plans, polygons, paths), or name a file that ends in .svg
