#!/usr/bin/env python3
"""Writes what is too long to write by hand: the textures, forest.ray and sea.ray, into the folder
this file lies in. What it makes is part of the repository; run it again after changing it."""

import math
import pathlib
import random
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent


def write_png(name, width, height, colour):
    """colour(u, v) gives red, green and blue in [0, 1]; v goes up."""

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    rows = bytearray()
    for y in range(height):
        rows.append(0)  # no filter
        for x in range(width):
            texel = colour((x + 0.5) / width, 1 - (y + 0.5) / height)
            rows += bytes(round(255 * min(max(c, 0), 1)) for c in texel)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    data = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))
    (FOLDER / "textures" / name).write_bytes(data)


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def chequer(u, v):
    return (0.9, 0.88, 0.82) if (int(u * 10) + int(v * 10)) % 2 else (0.16, 0.2, 0.26)


def bricks(u, v):
    row = int(v * 8)
    along = u * 4 + (0.5 if row % 2 else 0)
    x, y = along % 1, v * 8 % 1
    if x < 0.05 or y < 0.1:
        return (0.75, 0.72, 0.68)
    shade = random.Random(row * 16 + int(along) % 4).uniform(-0.08, 0.08)
    return (0.62 + shade, 0.28 + shade, 0.2 + shade)


def planet(u, v):
    """Lands and seas, made of waves that meet again where the map ends."""
    latitude = (v - 0.5) * math.pi
    longitude = u * 2 * math.pi
    x, y, z = (math.cos(latitude) * math.cos(longitude),
               math.cos(latitude) * math.sin(longitude), math.sin(latitude))
    height = (math.sin(3.1 * x + 1.7 * y) + math.sin(4.3 * y - 2.2 * z + 1) +
              math.sin(3.7 * z + 2.9 * x + 2) + 0.5 * math.sin(9 * x * y + 7 * z))
    if abs(latitude) > 1.25 + 0.06 * height:
        return (0.95, 0.97, 1)
    if height > 0.35:
        return mix((0.2, 0.5, 0.18), (0.6, 0.5, 0.3), min((height - 0.35) / 1.6, 1))
    return mix((0.04, 0.12, 0.42), (0.12, 0.42, 0.68), min(max((height + 2) / 2.3, 0), 1))


def sky(u, v):
    """Light at the horizon, and like far ground below it."""
    if v < 0.5:
        return mix((0.3, 0.32, 0.3), (0.62, 0.66, 0.68), max(0, 1 - (0.5 - v) * 8))
    return mix((0.8, 0.86, 0.92), (0.2, 0.4, 0.72), min((v - 0.5) * 3.2, 1))


def polish(u, v):
    """White where a surface shines: in rings."""
    ring = 0.5 + 0.5 * math.cos(40 * math.hypot(u - 0.5, v - 0.5))
    return (ring, ring, ring)


def write_textures():
    write_png("chequer.png", 200, 200, chequer)
    write_png("bricks.png", 128, 128, bricks)
    write_png("planet.png", 256, 128, planet)
    write_png("sky.png", 2, 64, sky)
    write_png("polish.png", 64, 64, polish)


def write_forest():
    choose = random.Random(7)
    lines = ["""SBT-raytracer 1.0
// A clearing in a wood of cones and cylinders. Written by make_scenes.py.
camera {
  position = (0, 2.6, 15);
  viewdir = (0, -0.0995, -0.995);
  updir = (0, 0.995, -0.0995);
  fov = 40;
  aspectratio = 1.5;
}
ambient_light { color = (0.35, 0.4, 0.5); }
directional_light { direction = (-0.55, -0.75, -0.45); color = (0.95, 0.88, 0.7); }

// The sky: a sphere around all that lets light pass.
rotate(1, 0, 0, -1.5707963267948966, scale(60, sphere {
  name = "sky"; material = { emissive = map("textures/sky.png"); transmissive = (1, 1, 1); }; }));

material = { name = "ground"; ambient = (0.3, 0.42, 0.2); diffuse = (0.36, 0.5, 0.22); };
rotate(1, 0, 0, -1.5707963267948966, scale(80, 80, 1, square { material = ground; }));
material = { name = "bark"; ambient = (0.3, 0.2, 0.12); diffuse = (0.42, 0.28, 0.17); };
material = { name = "needles_0"; ambient = (0.1, 0.28, 0.16); diffuse = (0.12, 0.38, 0.2);
             specular = (0.08, 0.1, 0.08); shininess = 8; };
material = { name = "needles_1"; ambient = (0.14, 0.32, 0.12); diffuse = (0.2, 0.45, 0.16); };
material = { name = "needles_2"; ambient = (0.22, 0.3, 0.08); diffuse = (0.36, 0.46, 0.12); };
"""]
    trees = []
    while len(trees) < 70:
        x, z = choose.uniform(-14, 14), choose.uniform(-24, 6)
        in_clearing = (x / 4) ** 2 + ((z - 5) / 8) ** 2 < 1
        if in_clearing or any(math.hypot(x - a, z - b) < 1.3 for a, b in trees):
            continue
        trees.append((x, z))
    for x, z in trees:
        size = choose.uniform(0.8, 1.5)
        turn = choose.uniform(0, 6.28)
        lean = choose.uniform(0, 0.04)
        lines.append(f"translate({x:.2f}, 0, {z:.2f}, rotate({math.cos(turn):.3f}, 0, "
                     f"{math.sin(turn):.3f}, {lean:.3f}, rotate(1, 0, 0, -1.5707963, "
                     f"scale({size:.2f}, {{")
        lines.append("  scale(0.12, 0.12, 1, cylinder { material = bark; })")
        lines.append(f"  material = needles_{choose.randrange(3)};")
        for height, radius in ((0.5, 0.85), (1.15, 0.65), (1.75, 0.42)):
            lines.append(f"  translate(0, 0, {height}, cone {{ height = {1.9 * radius:.2f}; "
                         f"bottom_radius = {radius}; }})")
        lines.append("}))));")
    lines.append("""
// What stands in the clearing: a well without a lid, and stumps.
translate(0, 0, 4, rotate(1, 0, 0, -1.5707963, {
  material = { ambient = (0.3, 0.3, 0.32); diffuse = (0.55, 0.54, 0.52); };
  cone { name = "well"; capped = false; height = 0.7; bottom_radius = 0.75; top_radius = 0.7; }
  cone { name = "inner wall"; capped = false; height = 0.7; bottom_radius = 0.6; top_radius = 0.55; }
  translate(0, 0, 0.3, scale(0.6, 0.6, 0.02, cylinder {
    material = { ambient = (0.02, 0.05, 0.08); diffuse = (0.03, 0.08, 0.12);
                 reflective = (0.4, 0.45, 0.5); };
  }));
}));
translate(1.6, 0, 6.2, rotate(1, 0, 0, -1.5707963, cone {
  material = bark; height = 0.45; bottom_radius = 0.4; top_radius = 0.3; }));
translate(-1.5, 0, 6.6, rotate(1, 0, 0, -1.5707963, cone {
  material = bark; height = 0.3; bottom_radius = 0.45; top_radius = 0.36; }));
""")
    (FOLDER / "forest.ray").write_text("\n".join(lines))


def write_sea():
    """One mesh with normals and a material for each point, one whose normals are generated."""
    count = 25

    def height(x, y):
        return 0.16 * math.sin(2.1 * x + 0.4) * math.cos(1.6 * y) + 0.09 * math.sin(3.3 * y + x)

    def normal(x, y):
        step = 1e-4
        return (-(height(x + step, y) - height(x - step, y)) / (2 * step),
                -(height(x, y + step) - height(x, y - step)) / (2 * step), 1)

    places = [(-3 + 6 * i / (count - 1), -3 + 6 * j / (count - 1))
              for j in range(count) for i in range(count)]

    def vectors(values):
        texts = [f"({a:.3f},{b:.3f},{c:.3f})" for a, b, c in values]
        return ",\n    ".join(", ".join(texts[i:i + 4]) for i in range(0, len(texts), 4))

    def level(x, y):
        h = height(x, y)
        return "foam" if h > 0.13 else "crest" if h > 0.03 else "slope" if h > -0.08 else "deep"

    levels = [level(x, y) for x, y in places]
    corners = [j * count + i for j in range(count - 1) for i in range(count - 1)]
    faces = [f"({a},{a + 1},{a + count + 1},{a + count})" for a in corners]

    def joined(texts, in_line):
        return ",\n    ".join(", ".join(texts[i:i + in_line])
                              for i in range(0, len(texts), in_line))

    around = 8
    buoy = [(0, 0, 0.9)]
    buoy += [(r * math.cos(2 * math.pi * k / around), r * math.sin(2 * math.pi * k / around), z)
             for z, r in ((0.5, 0.28), (0.1, 0.42), (-0.3, 0.3)) for k in range(around)]
    buoy_faces = [f"(0,{1 + k},{1 + (k + 1) % around})" for k in range(around)]
    for ring in range(2):
        begin = 1 + ring * around
        buoy_faces += [f"({begin + k},{begin + around + k},{begin + around + (k + 1) % around},"
                       f"{begin + (k + 1) % around})" for k in range(around)]
    buoy_faces.append("(" + ",".join(str(1 + 3 * around - 1 - k) for k in range(around)) + ")")

    (FOLDER / "sea.ray").write_text(f"""SBT-raytracer 1.1
/* A sea of one mesh with a normal and a material for each point, a buoy whose normals are
   generated, and a stone with flat faces. Written by make_scenes.py. */
camera {{
  position = (0, -6, 2.4)
  viewdir = (0, 0.9397, -0.342)
  updir = (0, 0.342, 0.9397)
  fov = 42
  aspectratio = 1.5
}}
ambient_light {{ colour = (0.35, 0.35, 0.4) }}
directional_light {{ direction = (0.6, 0.5, -0.62); colour = (0.9, 0.85, 0.75) }}
point_light {{ position = (2, -2, 3); colour = (0.4, 0.4, 0.5);
  constant_attenuation_coeff = 0.4; linear_attenuation_coeff = 0.1;
  quadratic_attenuation_coeff = 0.01 }}

// The sky: a sphere around all that lets light pass.
scale(60, sphere {{
  name = "sky"; material = {{ emissive = map("textures/sky.png") transmissive = (1, 1, 1) }} }})

material = {{ name deep; ambient = (0.02, 0.1, 0.2); diffuse = (0.03, 0.16, 0.34);
             specular = (0.5, 0.5, 0.5); shininess = 40; reflective = (0.1, 0.1, 0.12) }}
material = {{ name slope; ambient = (0.04, 0.2, 0.3); diffuse = (0.05, 0.32, 0.48) }}
material = {{ name crest; ambient = (0.1, 0.32, 0.36); diffuse = (0.14, 0.52, 0.56) }}
material = {{ name foam; ambient = (0.5, 0.55, 0.58); diffuse = (0.8, 0.86, 0.88);
             reflective = (0, 0, 0) }}
material = deep

trimesh {{
  name = "sea"
  points = (
    {vectors((x, y, height(x, y)) for x, y in places)})
  normals = (
    {vectors(normal(x, y) for x, y in places)})
  materials = (
    {joined(levels, 12)})
  faces = (
    {joined(faces, 5)})
}}

translate(-0.9, -0.6, 0.1, rotate(0.8, 0.6, 0, 0.2, polymesh {{
  name = "buoy"
  material = {{ ambient = (0.3, 0.06, 0.03); diffuse = (0.8, 0.16, 0.08);
               specular = (0.6, 0.6, 0.6); shininess = 30; reflective = (0, 0, 0) }}
  faces = (
    {joined(buoy_faces, 6)})
  points = (
    {vectors(buoy)})
  gennormals
}}))

translate(1.3, 0.2, 0, scale(0.7, trimesh {{
  name = "stone"
  material = {{ ambient = (0.2, 0.2, 0.2); diffuse = (0.5, 0.48, 0.45); reflective = (0, 0, 0);
               specular = (0, 0, 0) }}
  points = ((-0.9,-0.7,-0.5), (0.8,-0.9,-0.5), (1,0.6,-0.5), (-0.6,0.9,-0.5),
            (-0.5,-0.3,0.5), (0.3,-0.5,0.7), (0.5,0.3,0.6), (-0.3,0.4,0.4))
  faces = ((3,2,1,0), (4,5,6,7), (0,1,5,4), (1,2,6,5), (2,3,7,6), (3,0,4,7))
}}))
""")


write_textures()
write_forest()
write_sea()
