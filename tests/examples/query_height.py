"""Asks a scene's sea for the water under three points of a hull, through the C interface:
   python3 query_height.py SCENE.yaml [LIBRARY]"""
import ctypes as c
import sys

Doubles = c.POINTER(c.c_double)


class Points(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("frame", c.c_uint32), ("count", c.c_size_t),
                ("first", Doubles), ("second", Doubles), ("wanted", c.POINTER(c.c_uint8))]


class Samples(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32)] + [
        (name, Doubles) for name in (
            "height", "slope_east", "slope_north", "vertical_velocity", "orbital_east",
            "orbital_north", "orbital_up", "error", "bound")] + [
        ("status", c.POINTER(c.c_uint32))]


seaway = c.CDLL(sys.argv[2] if len(sys.argv) > 2 else "libseaway.so.0")
seaway.seaway_last_error.restype = c.c_char_p
seaway.seaway_sea_step_to.argtypes = [c.c_void_p, c.c_double]
seaway.seaway_sea_sample.argtypes = [c.c_void_p, c.c_double] + 3 * [c.c_void_p]


def check(status):
    if status != 0:
        sys.exit(seaway.seaway_last_error().decode())


def made(structure):
    """A structure with its defaults."""
    it = structure()
    name = structure.__name__.lower()
    getattr(seaway, f"seaway_{name}_init")(c.byref(it), c.c_size_t(c.sizeof(it)))
    return it


sea = c.c_void_p()
check(seaway.seaway_sea_from_file(sys.argv[1].encode(), None, c.byref(sea)))
points, samples = made(Points), made(Samples)
east, north, height = (c.c_double * 3)(0, 10, 20), (c.c_double * 3)(), (c.c_double * 3)()
points.count, points.first, points.second = 3, east, north
samples.height = height
for t in (0.0, 0.5, 1.0, 1.5):
    check(seaway.seaway_sea_step_to(sea, t))
    check(seaway.seaway_sea_sample(sea, t, c.byref(points), None, c.byref(samples)))
    print(t, "s:", ", ".join(f"{h:+.3f} m" for h in height))
seaway.seaway_sea_destroy(sea)
