"""A composite section with coarse cells, wide enough that no side is felt before 0.6 s: sand, rubble, a caisson."""

SCENE = """
[mesh]
geometry = "composite"
[mesh.parameters]
seabed_front = 60
seabed_back = 60
cells = 0.5
[regions.seabed]
kind = "porous"
shear_modulus = 30e6
poissons_ratio = 0.33
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1e-4
damping = { ratio = 0.05, frequencies = [1, 10] }
[regions.mound]
kind = "porous"
shear_modulus = 50e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 0.15
damping = { ratio = 0.05, frequencies = [1, 10] }
[regions.caisson]
kind = "rigid"
density = 2100.0
[boundaries]
base = { displacement = "fixed", pressure = "sealed" }
left = { displacement = "roller", pressure = "sealed" }
right = { displacement = "roller", pressure = "sealed" }
bed = { pressure = "open" }
mound_surface = { pressure = "open" }
front = {}
back = {}
top = {}
[loads.impulse]
boundary = "front"
kind = "force"
pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }
[time]
end = 0.6
"""
WIDTH = 18.0  # of the caisson (m)
