/*
 * Seaway's C interface: one sea for a vehicle simulator.
 *
 * Units are SI: metres, seconds, newtons. Angles are degrees and say so. Time is seconds since the
 * scene's epoch, and every question carries its own.
 *
 * Frames. Geodetic: WGS84 latitude and longitude. Sea plane: a local frame at the scene's anchor, x
 * east, y north, z up from the still-water level. Body: x forward, y to port, z up. Headings are
 * true, clockwise from north; pitch is positive bow up, roll positive starboard down.
 *
 * Objects are opaque and made by a function that writes a handle, NULL where it fails. To destroy
 * NULL does nothing. A handle that has been destroyed must not be used again, nor one while
 * another thread destroys it: that is the caller's error and is not detected. The library stays
 * loaded once it is: dlclose does nothing.
 *
 * Structures begin with their size, `struct_size`, by which later versions tell who calls. Make
 * them with `seaway_..._default()`, or, where a compiler of C is not at hand, `seaway_..._init(&it,
 * size)`. A size that this version does not know is refused with SEAWAY_BAD_STRUCT.
 *
 * Errors. Functions that return seaway_status return SEAWAY_OK or say what is wrong;
 * seaway_last_error() then has the message: file, line, key, value and what is allowed, where there
 * are any. No output is written by a call that fails, unless its text says otherwise. No call
 * throws, ends the program or writes to standard output. Warnings go to spdlog's default logger,
 * which is the standard error stream unless the program has set another.
 *
 * Threads. "Thread-safe" means: from any number of threads, also while another steps, renders or
 * moves vessels of the same sea. A question asked meanwhile sees the sea as it was before or after,
 * never between. Functions that change a sea take turns among themselves.
 *
 * NULL for a pointer that is not said to be "or NULL" is refused with SEAWAY_BAD_ARGUMENT.
 */
#ifndef SEAWAY_H
#define SEAWAY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SEAWAY_API __attribute__((visibility("default")))
#else
#define SEAWAY_API
#endif

/* ---- version and errors ---------------------------------------------------------------------- */

/* Version of this header. */
#define SEAWAY_VERSION_MAJOR 0
#define SEAWAY_VERSION_MINOR 1
#define SEAWAY_VERSION_PATCH 0

/* Version of the library that runs, such as "0.1.0". Thread-safe; the text is constant. */
SEAWAY_API const char* seaway_version(void);

typedef enum seaway_status {
  SEAWAY_OK = 0,
  SEAWAY_BAD_ARGUMENT = 1,     /* a null pointer, or a number out of its range */
  SEAWAY_BAD_STRUCT = 2,       /* a struct_size that this version does not know */
  SEAWAY_BAD_INPUT = 3,        /* a scene, file or mesh that is not allowed as it is */
  SEAWAY_NOT_FOUND = 4,        /* no vessel or camera of that name or number */
  SEAWAY_BUFFER_TOO_SMALL = 5, /* what is written does not fit */
  SEAWAY_OUT_OF_MEMORY = 6,
  SEAWAY_FAILED = 7 /* anything else: a fault of Seaway or of the machine */
} seaway_status;

/* Name of a seaway_status, such as "bad input"; "unknown status" for any other number. Thread-safe;
 * the text is constant. */
SEAWAY_API const char* seaway_status_name(int status);

/* Message of the calling thread's last call that failed; "" before the first. Never NULL. The text
 * stays until another call fails on this thread; 4095 bytes at the most. Thread-safe. */
SEAWAY_API const char* seaway_last_error(void);

/* ---- a sea ----------------------------------------------------------------------------------- */

/* A scene's sea with its vessels and cameras, at a time of its own from which it is stepped on. */
typedef struct seaway_sea seaway_sea;

typedef struct seaway_sea_options {
  uint32_t struct_size;
  uint32_t reserved; /* 0 */
  double start_time; /* s, >= 0: vessels have sailed since 0 when the sea appears; default 0 */
} seaway_sea_options;

SEAWAY_API void seaway_sea_options_init(seaway_sea_options* options, size_t size);

/* A sea from a scene file (YAML; configs/SCHEMA.md lists its keys), UTF-8. `options` or NULL:
 * defaults. Fits the waves: some 0.1 s. On failure `*sea` is NULL. Thread-safe.
 * SEAWAY_BAD_INPUT: whatever a scene may not be, with file, line, key and what is allowed. */
SEAWAY_API seaway_status seaway_sea_from_file(const char* path, const seaway_sea_options* options,
                                              seaway_sea** sea);

/* The same from the text of a scene, ended by a zero. Files that it names are relative to
 * `folder`; NULL: the working folder. Messages call the text `FOLDER/<text>`. */
SEAWAY_API seaway_status seaway_sea_from_text(const char* yaml, const char* folder,
                                              const seaway_sea_options* options, seaway_sea** sea);

/* Ends a sea; NULL: nothing. Hulls made from it live on. */
SEAWAY_API void seaway_sea_destroy(seaway_sea* sea);

/* The sea's time, s, and the length of its steps (`run.step_s`). NaN for NULL. Thread-safe. */
SEAWAY_API double seaway_sea_time(const seaway_sea* sea);
SEAWAY_API double seaway_sea_step_length(const seaway_sea* sea);

/* One step on: vessels sail, heave, roll and pitch, wakes spread. Thread-safe.
 * SEAWAY_BAD_INPUT where a vessel runs aground or leaves the range of the scene's plane (500 km):
 * the sea stays as it was, and stands still until seaway_sea_restart. */
SEAWAY_API seaway_status seaway_sea_step(seaway_sea* sea);

/* Whole steps as long as they do not pass `time`; none where it is not later than the sea's time.
 * As seaway_sea_step. */
SEAWAY_API seaway_status seaway_sea_step_to(seaway_sea* sea, double time);

/* The scene anew at `time` (s, >= 0) as a sea made with that start time: hosts' poses are
 * forgotten, listeners stay. On failure the sea is as before. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_restart(seaway_sea* sea, double time);

/* ---- the water ------------------------------------------------------------------------------- */

typedef enum seaway_frame {
  SEAWAY_SEA_PLANE = 0, /* first: east, second: north, m; vectors are along the plane's axes */
  SEAWAY_GEODETIC = 1   /* first: latitude, second: longitude, degrees; vectors are along true
                           east and north at the point */
} seaway_frame;

/* Where to ask: arrays of `count` numbers. */
typedef struct seaway_points {
  uint32_t struct_size;
  uint32_t frame;        /* a seaway_frame; default SEAWAY_SEA_PLANE */
  size_t count;          /* 0 is allowed: nothing is asked */
  const double* first;   /* east m or latitude degrees */
  const double* second;  /* north m or longitude degrees */
  const uint8_t* wanted; /* or NULL: all. 0: this point is passed over, its outputs stay */
} seaway_points;

SEAWAY_API void seaway_points_init(seaway_points* points, size_t size);

/* How exact answers are wanted. The default asks for all waves. */
typedef struct seaway_sample_options {
  uint32_t struct_size;
  uint32_t own_vessel; /* 0: none; else a vessel's number + 1: its own wake is left out, for a hull
                          must not ride waves that are in its resistance already */
  double tolerance;    /* m, >= 0: height that may be left out, one standard deviation */
  double shortest_wavelength; /* m, >= 0: shorter waves are left out */
  uint32_t parallel; /* 1: share batches above 4096 points among oneTBB's threads; default 0 */
  uint32_t reserved; /* 0 */
} seaway_sample_options;

SEAWAY_API void seaway_sample_options_init(seaway_sample_options* options, size_t size);

/* What an answer has to say: bits of `status`. 0: nothing. */
#define SEAWAY_SAMPLE_TRUNCATED 0x1u         /* waves left out as asked; `error` says how much */
#define SEAWAY_SAMPLE_NOT_FINITE 0x2u        /* the point or the time is NaN or infinite: NaN */
#define SEAWAY_SAMPLE_OUT_OF_RANGE 0x4u      /* farther than 500 km (geodetic) or 1e12 m, s: NaN */
#define SEAWAY_SAMPLE_NO_KINEMATICS 0x8u     /* Perlin octaves have no orbital motion: NaN */
#define SEAWAY_SAMPLE_ABOVE_SURFACE 0x10u    /* the point is in the air: no motion, NaN */
#define SEAWAY_SAMPLE_BELOW_BED 0x20u        /* the point is in the bed: no motion, NaN */
#define SEAWAY_SAMPLE_WAKE_OUT_OF_TIME 0x40u /* wakes are not known at this time: their nearest */
#define SEAWAY_SAMPLE_WAKE_PARTIAL 0x80u     /* at a wake's border some of its waves are missing */
#define SEAWAY_SAMPLE_DRY 0x100u             /* ashore: NaN */

/* Answers: arrays of at least `count` numbers each; NULL: not wanted, and not computed where that
 * saves time. */
typedef struct seaway_samples {
  uint32_t struct_size;
  uint32_t reserved;         /* 0 */
  double* height;            /* m above the still-water level */
  double* slope_east;        /* d(height)/d(east) */
  double* slope_north;       /* d(height)/d(north) */
  double* vertical_velocity; /* d(height)/dt at the fixed point, m/s */
  double* orbital_east;      /* velocity of the water at the surface, without the current, m/s */
  double* orbital_north;
  double* orbital_up;
  double* error;    /* one standard deviation of the height left out, m */
  double* bound;    /* largest numerical error of the height, m */
  uint32_t* status; /* SEAWAY_SAMPLE_... */
} seaway_samples;

SEAWAY_API void seaway_samples_init(seaway_samples* samples, size_t size);

/* The surface at points and at `time`, any finite one, before the epoch too. `options` or NULL:
 * defaults. Points, or a time, that are not finite or out of range are no error: their values are
 * NaN and their status says why; the others are unharmed.
 *
 * Without vessels' wakes, foam and what else the sea's steps bring about, the answer depends on the
 * scene, point and time alone: the same bits for any batch, order and thread. Wakes are those of
 * the sea's own time, known from the step before it to the step after.
 *
 * Thread-safe. In the sea plane it allocates nothing once a thread has made its first call
 * (`parallel` 0). */
SEAWAY_API seaway_status seaway_sea_sample(const seaway_sea* sea, double time,
                                           const seaway_points* points,
                                           const seaway_sample_options* options,
                                           const seaway_samples* out);

/* Answers below the surface; as seaway_samples. */
typedef struct seaway_motions {
  uint32_t struct_size;
  uint32_t reserved;     /* 0 */
  double* velocity_east; /* of the water, without the current, m/s */
  double* velocity_north;
  double* velocity_up;
  double* acceleration_east; /* local rate of change in the water's frame, m/s^2 */
  double* acceleration_north;
  double* acceleration_up;
  double* dynamic_pressure; /* of the waves alone, Pa */
  double* pressure;         /* gauge: hydrostatic and dynamic, Pa; 0 at the surface */
  double* surface_height;   /* above the point, m above the still-water level */
  uint32_t* status;         /* SEAWAY_SAMPLE_... */
} seaway_motions;

SEAWAY_API void seaway_motions_init(seaway_motions* motions, size_t size);

/* Motion and pressure of the water at points `height` (m above the still-water level, negative
 * below it; `points->count` of them): linear waves with Wheeler's stretching. Otherwise as
 * seaway_sea_sample; `parallel` is not looked at. */
SEAWAY_API seaway_status seaway_sea_sample_motion(const seaway_sea* sea, double time,
                                                  const seaway_points* points, const double* height,
                                                  const seaway_sample_options* options,
                                                  const seaway_motions* out);

typedef struct seaway_ray_options {
  uint32_t struct_size;
  uint32_t flat;        /* 1: a flat sea plane; default 0: the sea curves away below the origin */
  double tolerance;     /* m along the ray, > 0; default 1e-4 */
  double near_distance; /* m, >= 0: where rays start; default 0.1 */
  double far_distance;  /* m, above near_distance: where they give up; default 100e3 */
} seaway_ray_options;

SEAWAY_API void seaway_ray_options_init(seaway_ray_options* options, size_t size);

/* Distances along `count` rays to the water, from above or below, for lidars and radars: m to the
 * first hit, infinity where there is none, NaN for a ray that is not finite. `origins` and
 * `directions` hold 3 numbers a ray: east, north, up in the sea plane, m; directions of any length
 * above 0. Ashore, flat ground ends a ray. `options` or NULL: defaults. Thread-safe; allocates. */
SEAWAY_API seaway_status seaway_sea_cast_rays(const seaway_sea* sea, double time, size_t count,
                                              const double* origins, const double* directions,
                                              const seaway_ray_options* options, double* distances);

/* ---- places ---------------------------------------------------------------------------------- */

/* `count` geodetic positions (degrees) in the sea plane, m: azimuthal equidistant about the anchor
 * on WGS84, within 1 mm of the geodesic. NaN for what is not finite or farther than 500 km.
 * `convergence_deg` or NULL: from the plane's north to true north there, degrees
 * counter-clockwise. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_plane_from_geodetic(const seaway_sea* sea, size_t count,
                                                        const double* latitude_deg,
                                                        const double* longitude_deg, double* east,
                                                        double* north, double* convergence_deg);

/* The way back; longitudes in [-180, 180]. NaN for what is not finite or farther than 500 km.
 * Thread-safe. */
SEAWAY_API seaway_status seaway_sea_geodetic_from_plane(const seaway_sea* sea, size_t count,
                                                        const double* east, const double* north,
                                                        double* latitude_deg,
                                                        double* longitude_deg);

/* Height of the still-water level above the WGS84 ellipsoid at `count` geodetic positions, m: the
 * geoid where GeographicLib's data are installed (else taken for the ellipsoid), and the scene's
 * `water_level_m`. NaN for what is not finite. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_still_water_level(const seaway_sea* sea, size_t count,
                                                      const double* latitude_deg,
                                                      const double* longitude_deg,
                                                      double* ellipsoidal_height);

/* Somebody who feels or sees the water around a place. */
typedef struct seaway_listener {
  double east, north; /* sea plane, m */
  double radius;      /* m about it, >= 0 */
} seaway_listener;

/* Wakes run only where somebody is near: vessels, cameras that have rendered, and these listeners,
 * from now on in place of those given before. They are rebuilt at once from vessels' pasts, within
 * 1 % of the height of wakes that have run all along. `listeners` or NULL for a count of 0.
 * Thread-safe. */
SEAWAY_API seaway_status seaway_sea_listen(seaway_sea* sea, size_t count,
                                           const seaway_listener* listeners);

/* ---- vessels --------------------------------------------------------------------------------- */

/* Number of the scene's vessels, which never changes; 0 for NULL. Thread-safe. */
SEAWAY_API size_t seaway_sea_vessel_count(const seaway_sea* sea);

/* Name of a vessel, from 0; NULL where there is none. Lives as long as the sea. Thread-safe. */
SEAWAY_API const char* seaway_sea_vessel_name(const seaway_sea* sea, size_t vessel);

/* Number of the vessel of that name. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_find_vessel(const seaway_sea* sea, const char* name,
                                                size_t* vessel);

typedef struct seaway_pose {
  uint32_t struct_size;
  uint32_t frame;     /* a seaway_frame: which position is meant where a pose is given; poses that
                         are asked for have both. Default SEAWAY_SEA_PLANE */
  double east, north; /* of the body's origin, sea plane, m */
  double latitude_deg, longitude_deg;
  double height;      /* of the body's origin above the still-water level, m */
  double heading_deg; /* true */
  double pitch_deg;   /* bow up */
  double roll_deg;    /* starboard down */
} seaway_pose;

SEAWAY_API void seaway_pose_init(seaway_pose* pose, size_t size);

/* Where a vessel is at the sea's time. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_vessel_pose(const seaway_sea* sea, size_t vessel,
                                                seaway_pose* pose);

/* A host places a vessel at `time` (s): from now on it neither sails its course nor rocks of its
 * own, but is where the host says: between two poses on the straight line between them, after the
 * last reckoned on for a second, then at rest. Its wake and its trail follow as the sea is stepped:
 * place it at the time to which you step next, then step. A pose farther from the last than
 * 100 m/s would take it puts it there without a wake on the way. Poses must come at rising times,
 * none before the sea's time. A host may sail where it likes: running aground is its own affair.
 * Thread-safe.
 * SEAWAY_BAD_ARGUMENT: a number that is not finite, a time that is not later, a place out of
 * range. */
SEAWAY_API seaway_status seaway_sea_place_vessel(seaway_sea* sea, size_t vessel, double time,
                                                 const seaway_pose* pose);

/* ---- loads on hulls -------------------------------------------------------------------------- */

/* A hull's mesh and mass, ready for loads. Immutable; belongs to no sea. */
typedef struct seaway_hull seaway_hull;

typedef enum seaway_load_level {
  SEAWAY_COLUMNS = 0,     /* vertical columns: long waves, crowds of hulls */
  SEAWAY_MESH = 1,        /* wet triangles, hydrostatic pressure below the actual surface */
  SEAWAY_MESH_DYNAMIC = 2 /* and the waves' own pressure (Froude-Krylov, stretched) */
} seaway_load_level;

typedef struct seaway_hull_options {
  uint32_t struct_size;
  uint32_t level;              /* a seaway_load_level; default SEAWAY_MESH_DYNAMIC */
  double mass;                 /* kg, > 0; no default */
  double centre_of_gravity[3]; /* body frame, m; default the origin */
  double gyradii[3];           /* m about x, y, z; 0: 0.35 beam, 0.25 and 0.25 length (default) */
  double metres_per_unit;      /* of a file, > 0; default 1 */
  double shortest_wavelength;  /* m: shorter waves are left out; negative (default): length / 4 */
  double form_drag;            /* pressure 1/2 rho C u|u| on panels; default 0.5 */
  double skin_friction;        /* coefficient; negative (default): the ITTC 1957 line */
  double slamming;             /* default 0: off */
  double wind_drag;            /* default 0.5 */
  double damping[3];           /* of heave, roll, pitch, parts of critical; 0.3, 0.1, 0.3 */
  double added_mass[6];        /* parts of the mass and of the moments of inertia; default 0 */
  uint32_t triangles;          /* of shapes, about; default 800 */
  uint32_t reserved;           /* 0 */
} seaway_hull_options;

SEAWAY_API void seaway_hull_options_init(seaway_hull_options* options, size_t size);

/* A hull from a file (STL, OBJ, glTF, GLB; x forward, z up) or a shape: `box:LENGTH,BEAM,DEPTH`,
 * `wigley:LENGTH,BEAM,DRAFT,FREEBOARD`, `sphere:RADIUS`, `spar:DIAMETER,DRAFT,FREEBOARD`, in m. On
 * failure `*hull` is NULL. Thread-safe.
 * SEAWAY_BAD_INPUT: no such file, a mesh that is not watertight, a hull that would sink. */
SEAWAY_API seaway_status seaway_hull_from_file(const char* file_or_shape,
                                               const seaway_hull_options* options,
                                               seaway_hull** hull);

/* A hull from triangles in the body frame: 3 coordinates a vertex, m; 3 vertex numbers a triangle,
 * counter-clockwise seen from outside. As seaway_hull_from_file. */
SEAWAY_API seaway_status seaway_hull_from_triangles(size_t vertex_count, const double* vertices,
                                                    size_t triangle_count,
                                                    const uint32_t* triangles,
                                                    const seaway_hull_options* options,
                                                    seaway_hull** hull);

/* The hull of a vessel of the scene, as its file describes it. As seaway_hull_from_file. */
SEAWAY_API seaway_status seaway_hull_from_vessel(const seaway_sea* sea, size_t vessel,
                                                 seaway_hull** hull);

/* Ends a hull; NULL: nothing. */
SEAWAY_API void seaway_hull_destroy(seaway_hull* hull);

typedef struct seaway_hull_facts {
  uint32_t struct_size;
  uint32_t triangles;
  double mass;                 /* kg */
  double centre_of_gravity[3]; /* body frame, m */
  double lower[3], upper[3];   /* corners of the box about the mesh, body frame, m */
  double rest_height;          /* of the body's origin above still water, upright at rest, m */
  double rest_volume;          /* submerged then, m^3 */
  double shortest_wavelength;  /* of the waves that count, m */
} seaway_hull_facts;

SEAWAY_API void seaway_hull_facts_init(seaway_hull_facts* facts, size_t size);
SEAWAY_API seaway_status seaway_hull_describe(const seaway_hull* hull, seaway_hull_facts* facts);

/* Where a body is and how it moves, along the sea plane's axes. */
typedef struct seaway_body {
  uint32_t struct_size;
  uint32_t reserved;          /* 0 */
  double position[3];         /* of the body's origin: east, north, up, m */
  double attitude[4];         /* w, x, y, z of the unit quaternion that turns body into sea plane */
  double velocity[3];         /* of the body's origin, m/s */
  double angular_velocity[3]; /* rad/s */
} seaway_body;

SEAWAY_API void seaway_body_init(seaway_body* body, size_t size);

typedef struct seaway_load_options {
  uint32_t struct_size;
  uint32_t own_vessel;          /* as in seaway_sample_options */
  double wind_east, wind_north; /* velocity of the air, m/s; NaN (default): no wind loads */
} seaway_load_options;

SEAWAY_API void seaway_load_options_init(seaway_load_options* options, size_t size);

/* Forces (N) along the sea plane's axes and moments (N m) about the body's origin. */
typedef struct seaway_loads {
  uint32_t struct_size;
  uint32_t status;            /* SEAWAY_SAMPLE_... */
  double force[3], moment[3]; /* all of the following together; no weight */
  double buoyancy_force[3], buoyancy_moment[3];
  double drag_force[3], drag_moment[3];
  double radiation_force[3], radiation_moment[3];
  double wind_force[3], wind_moment[3];
  double added_mass[6];         /* body frame about the centre of gravity, kg and kg m^2: an
                                   integrator that knows of it solves
                                   (M + A) a = force + weight + A water_acceleration */
  double water_acceleration[3]; /* m/s^2 */
  double submerged_volume;      /* m^3 */
  double wetted_area;           /* m^2; 0 for SEAWAY_COLUMNS */
  double left_out;              /* standard deviation of the height of the waves left out, m */
} seaway_loads;

SEAWAY_API void seaway_loads_init(seaway_loads* loads, size_t size);

/* What water and air do to a hull at `time`; `options` or NULL: defaults. A pose or time that is
 * not finite is no error: NaN and its status bit. Thread-safe; allocates nothing once a thread has
 * met its largest hull. */
SEAWAY_API seaway_status seaway_sea_hull_loads(const seaway_sea* sea, const seaway_hull* hull,
                                               double time, const seaway_body* body,
                                               const seaway_load_options* options,
                                               seaway_loads* loads);

/* ---- pictures -------------------------------------------------------------------------------- */

/* Number and names of the scene's cameras; as for vessels. */
SEAWAY_API size_t seaway_sea_camera_count(const seaway_sea* sea);
SEAWAY_API const char* seaway_sea_camera_name(const seaway_sea* sea, size_t camera);

/* A camera of the caller's own. Looks along its mount's bow, or to true north where it has none,
 * turned by yaw, pitch and roll. */
typedef struct seaway_camera {
  uint32_t struct_size;
  uint32_t stabilised;                /* 1: mounted, but does not heave, roll or pitch; default 0 */
  const char* mount;                  /* a vessel's name; NULL (default): a fixed camera */
  double position[3];                 /* mounted: in the body frame, m */
  double latitude_deg, longitude_deg; /* fixed */
  double height;                      /* fixed: above the still-water level, m; default 2 */
  double yaw_deg;                     /* clockwise */
  double pitch_deg;                   /* up, [-90, 90] */
  double roll_deg;                    /* right side down */
  double field_of_view_deg;           /* vertical, [0.01, 179]; default 60 */
} seaway_camera;

SEAWAY_API void seaway_camera_init(seaway_camera* camera, size_t size);

typedef struct seaway_render_options {
  uint32_t struct_size;
  uint32_t grid_columns, grid_rows; /* of the projected grid, [2, 4096]; 0 (default): the scene's */
  uint32_t reserved;                /* 0 */
  const char* backend; /* "osmesa" (default, NULL): on the processor; "egl", "egl:N": a graphics
                          card, from one thread alone */
} seaway_render_options;

SEAWAY_API void seaway_render_options_init(seaway_render_options* options, size_t size);

/* The caller's memory for a picture, rows from the top left. */
typedef struct seaway_image {
  uint32_t struct_size;
  uint32_t width, height; /* pixels, [1, 8192]; 0 and 0 (default): the scene's run.size */
  uint32_t reserved;      /* 0 */
  uint8_t* rgb;           /* sRGB, 3 bytes a pixel; or NULL */
  size_t rgb_size;        /* bytes there are, >= 3 width height */
  float* depth;           /* m along the camera's axis, infinity for sky; or NULL */
  size_t depth_size;      /* floats there are, >= width height */
} seaway_image;

SEAWAY_API void seaway_image_init(seaway_image* image, size_t size);

/* Size of the scene's pictures, pixels. Thread-safe. */
SEAWAY_API seaway_status seaway_sea_picture_size(const seaway_sea* sea, uint32_t* width,
                                                 uint32_t* height);

/* Draws what a camera sees at the sea's time: `own`, or where that is NULL the scene's camera of
 * that name; NULL: the first. `options` or NULL: defaults. Thread-safe; waits for steps and other
 * pictures of this sea. A failed call may have written a part of the picture only where it returns
 * SEAWAY_FAILED. */
SEAWAY_API seaway_status seaway_sea_render(seaway_sea* sea, const char* camera,
                                           const seaway_camera* own,
                                           const seaway_render_options* options,
                                           const seaway_image* image);

/* ---- description ----------------------------------------------------------------------------- */

/* The sea in JSON: version, time, anchor, sea state asked and realised, octaves, vessels, cameras,
 * effects with what they cost at the last step and picture. UTF-8, ended by a zero. `*needed` gets
 * the bytes that it takes, the zero included, also where it does not fit (SEAWAY_BUFFER_TOO_SMALL;
 * `buffer` may be NULL where `size` is 0). The first call samples the sea: some 10 ms.
 * Thread-safe. */
SEAWAY_API seaway_status seaway_sea_describe(const seaway_sea* sea, char* buffer, size_t size,
                                             size_t* needed);

/* ---- structures with their defaults ---------------------------------------------------------- */

/* seaway_T_default() for every structure T above. Inline, so that each caller's own size counts. */
#define SEAWAY_DEFAULT(T)             \
  static inline T T##_default(void) { \
    T made;                           \
    T##_init(&made, sizeof made);     \
    return made;                      \
  }
SEAWAY_DEFAULT(seaway_sea_options)
SEAWAY_DEFAULT(seaway_points)
SEAWAY_DEFAULT(seaway_sample_options)
SEAWAY_DEFAULT(seaway_samples)
SEAWAY_DEFAULT(seaway_motions)
SEAWAY_DEFAULT(seaway_ray_options)
SEAWAY_DEFAULT(seaway_pose)
SEAWAY_DEFAULT(seaway_hull_options)
SEAWAY_DEFAULT(seaway_hull_facts)
SEAWAY_DEFAULT(seaway_body)
SEAWAY_DEFAULT(seaway_load_options)
SEAWAY_DEFAULT(seaway_loads)
SEAWAY_DEFAULT(seaway_camera)
SEAWAY_DEFAULT(seaway_render_options)
SEAWAY_DEFAULT(seaway_image)
#undef SEAWAY_DEFAULT

#ifdef __cplusplus
}
#endif

#endif
