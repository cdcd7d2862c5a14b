/* The memory that `seaway serve SCENE --shm NAME` shares with hosts on the same machine. C11 and
 * C++20, Linux, little-endian and big-endian alike (both sides are on one machine).
 *
 * The segment is the POSIX shared memory /NAME, readable and writable by its owner alone (0600):
 *
 *   seaway_shm_header            one page
 *   slot 0 .. slot_count - 1     slot_size bytes each, from slots_offset on; one a host:
 *     seaway_shm_slot            one page
 *     cell 0 .. cell_count - 1   cell_size bytes each, from cells_offset on: the host's ring
 *       seaway_shm_request, seaway_shm_answer
 *       arrays                   SEAWAY_SHM_ARRAYS of point_limit doubles, array_stride bytes
 *                                apart, from arrays_offset on; then point_limit status words
 *     pixels                     from pixels_offset on: width * height * 3 bytes of colour, padded
 *                                to 64, then width * height floats of depth
 *
 * All offsets are multiples of 64. Words that both sides look at are 32 bits wide, are read and
 * written atomically and are slept on by futex (not private to a process).
 *
 * Who is alive is told by the kernel: the server holds an open-file-description lock (F_OFD_SETLK)
 * on byte 0 of the segment's file, the host of slot i on byte 1 + i. It ends with the process,
 * however that ended, and does not depend on process numbers.
 *
 * A host (1) locks the byte of a slot, (2) stores session 0, then 0 in `asked`, `client_waits` and
 * `pictures_asked`, (3) stores a new `session` other than 0, adds one to the header's `attention`
 * and wakes its sleepers, (4) waits until `served` is that session. Request n = 1, 2, .. is written
 * into cell (n - 1) % cell_count; then `asked` becomes n. The server answers in that order: it
 * writes the cell's answer, then `answered` becomes n. No more than cell_count requests are under
 * way. A host that goes stores session 0 and unlocks. One that finds no slot within its time adds
 * one to the header's `turned_away`, for the server's metrics alone. */
#ifndef SEAWAY_SHM_LAYOUT_H
#define SEAWAY_SHM_LAYOUT_H

#include <stdint.h>

#define SEAWAY_SHM_MAGIC UINT64_C(0x4d53594157414553) /* "SEAWAYSM" in little-endian memory */
#define SEAWAY_SHM_VERSION 1u
#define SEAWAY_SHM_PAGE 4096u
#define SEAWAY_SHM_TEXT 240u     /* bytes of a message, its final 0 included */
#define SEAWAY_SHM_NAME_LIMIT 64 /* bytes of a camera's name, its final 0 included */

/* What became of a call or a request. */
typedef enum seaway_shm_status {
  SEAWAY_SHM_OK = 0,
  SEAWAY_SHM_TIMEOUT = 1,       /* no answer in the time given; it may still come */
  SEAWAY_SHM_NO_SERVER = 2,     /* nobody serves under that name */
  SEAWAY_SHM_SERVER_GONE = 3,   /* the server has ended or died: reconnect */
  SEAWAY_SHM_NO_SLOT = 4,       /* as many hosts are connected as there are slots */
  SEAWAY_SHM_WRONG_VERSION = 5, /* the segment is laid out otherwise, or is none */
  SEAWAY_SHM_NOT_CONNECTED = 6,
  SEAWAY_SHM_RING_FULL = 7,  /* cell_count requests are under way: wait for the oldest */
  SEAWAY_SHM_TOO_LARGE = 8,  /* more points, poses or pixels than are served at once */
  SEAWAY_SHM_BAD_VALUE = 9,  /* the message says which, and what is allowed */
  SEAWAY_SHM_NOT_FOUND = 10, /* no such hull, vessel or camera */
  SEAWAY_SHM_MALFORMED = 11, /* a request that the layout does not allow */
  SEAWAY_SHM_NO_MEMORY = 12, /* the machine's shared memory is used up */
  SEAWAY_SHM_FAILED = 13,    /* the server's own fault, or the system's: see the message */
} seaway_shm_status;

/* seaway_shm_header.state, a futex word */
enum { SEAWAY_SHM_STARTING = 0, SEAWAY_SHM_SERVING = 1, SEAWAY_SHM_ENDED = 2 };

/* seaway_shm_request.kind */
enum {
  SEAWAY_SHM_SAMPLE = 1,      /* the water at `count` points */
  SEAWAY_SHM_DESCRIBE = 2,    /* JSON text about the sea, at arrays_offset, text_size bytes */
  SEAWAY_SHM_ADD_HULL = 3,    /* a hull of scene vessel `vessel`; the answer's `hull` */
  SEAWAY_SHM_PLACE_HULLS = 4, /* `count` seaway_shm_pose at arrays_offset, all at `time` */
  SEAWAY_SHM_REMOVE_HULL = 5  /* `hull`: its waves run out */
};

/* seaway_shm_request.flags: of samples, but for the last two */
enum {
  SEAWAY_SHM_GEODETIC = 1,         /* x is longitude, y latitude, degrees; vectors are true east
                                      and north. Else x east, y north in the sea plane, m */
  SEAWAY_SHM_HEIGHT_ONLY = 2,      /* slopes and vertical velocity are not wanted: unwritten */
  SEAWAY_SHM_ORBITAL_VELOCITY = 4, /* orbital velocities are wanted; else unwritten */
  SEAWAY_SHM_SERVERS_TIME = 8,     /* of any request: at the server's clock instead of `time` */
  SEAWAY_SHM_OWN_CAMERA = 16       /* of pictures alone: a camera that the request places */
};

/* Bits of a point's status; 0 is fine. Values that a bit makes meaningless are NaN. */
enum {
  SEAWAY_SHM_POINT_TRUNCATED = 1 << 0,        /* the tolerance left octaves out: see error */
  SEAWAY_SHM_POINT_NOT_FINITE = 1 << 1,       /* point or time NaN or infinite: NaN */
  SEAWAY_SHM_POINT_OUT_OF_RANGE = 1 << 2,     /* too far to be served: NaN */
  SEAWAY_SHM_POINT_NO_KINEMATICS = 1 << 3,    /* no orbital velocity in such a sea */
  SEAWAY_SHM_POINT_WAKE_OUT_OF_TIME = 1 << 6, /* wakes of the nearest time there is */
  SEAWAY_SHM_POINT_WAKE_PARTIAL = 1 << 7,     /* some of a wake is missing */
  SEAWAY_SHM_POINT_DRY = 1 << 8               /* ashore: NaN */
};

/* The arrays of a cell, doubles; hosts write the first two. */
enum {
  SEAWAY_SHM_X = 0,
  SEAWAY_SHM_Y = 1,
  SEAWAY_SHM_HEIGHT = 2,     /* m above the still-water level */
  SEAWAY_SHM_SLOPE_EAST = 3, /* d height / d east */
  SEAWAY_SHM_SLOPE_NORTH = 4,
  SEAWAY_SHM_VERTICAL_VELOCITY = 5, /* of the surface at a fixed point, m/s */
  SEAWAY_SHM_ORBITAL_EAST = 6,      /* water at the surface, m/s, without the current */
  SEAWAY_SHM_ORBITAL_NORTH = 7,
  SEAWAY_SHM_ORBITAL_UP = 8,
  SEAWAY_SHM_ERROR = 9,  /* one standard deviation of the height left out, m */
  SEAWAY_SHM_BOUND = 10, /* largest numerical error of the height, m */
  SEAWAY_SHM_ARRAYS = 11
};

typedef struct seaway_shm_header {
  uint64_t magic; /* SEAWAY_SHM_MAGIC, stored when all else is ready */
  uint32_t version;
  uint32_t header_size; /* sizeof(seaway_shm_header) */
  uint32_t slot_count;
  uint32_t cell_count;  /* of each slot; a power of two */
  uint32_t point_limit; /* of one request */
  uint32_t pixel_limit; /* of one picture */
  uint64_t segment_size;
  uint64_t slots_offset, slot_size;     /* in the segment; multiples of SEAWAY_SHM_PAGE */
  uint64_t cells_offset, cell_size;     /* in a slot */
  uint64_t arrays_offset, array_stride; /* in a cell */
  uint64_t pixels_offset;               /* in a slot */
  uint64_t server_number;               /* of this start of a server, at random */
  uint8_t reserved[24];
  uint32_t state;          /* futex: SEAWAY_SHM_SERVING, .. */
  uint32_t attention;      /* futex: hosts come and go */
  uint32_t pictures_asked; /* futex: of all slots */
  uint32_t turned_away;    /* hosts: those that found no free slot add one and go */
  uint32_t padding[12];
} seaway_shm_header;

/* 128 bytes. Angles in degrees: heading true, clockwise; all zero where not used. */
typedef struct seaway_shm_request {
  uint32_t number; /* n, as `asked` */
  uint32_t kind, flags;
  uint32_t count;             /* of points or poses */
  double time;                /* s since the scene's epoch */
  double tolerance;           /* m, one standard deviation of height; 0: all waves */
  double shortest_wavelength; /* m; 0: all waves */
  uint32_t own_hull;          /* hull of this host that does not feel its own waves; 0: none */
  uint32_t hull;              /* to remove */
  uint32_t vessel;            /* of the scene, from 0 on */
  uint8_t reserved[76];
} seaway_shm_request;

/* 384 bytes */
typedef struct seaway_shm_answer {
  uint32_t number; /* of the request */
  uint32_t status; /* seaway_shm_status; arrays hold an answer only where it is OK */
  uint32_t hull;
  uint32_t text_size;
  double time;                 /* that was answered for */
  double wakes_from, wakes_to; /* that wakes cover, s; NaN without wakes */
  uint8_t reserved[104];
  char message[SEAWAY_SHM_TEXT]; /* why not, with a final 0; empty where OK */
} seaway_shm_answer;

/* Where a hull is. 64 bytes. Poses whose request has a time before the epoch, less than 0, leave no
 * foam and no smoothed water; the server's metrics count them as events `poses_before_epoch`. */
typedef struct seaway_shm_pose {
  uint32_t hull;
  uint32_t reserved;
  double latitude_deg, longitude_deg;
  double height;      /* of the body's origin above still water, m */
  double heading_deg; /* true */
  double pitch_deg;   /* bow up */
  double roll_deg;    /* starboard down */
  double reserved_too;
} seaway_shm_pose;

/* 192 bytes */
typedef struct seaway_shm_picture_request {
  char camera[SEAWAY_SHM_NAME_LIMIT]; /* of the scene; empty: the first */
  double time;
  uint32_t flags;         /* SEAWAY_SHM_SERVERS_TIME, SEAWAY_SHM_OWN_CAMERA */
  uint32_t width, height; /* pixels; 0: the scene's */
  uint32_t reserved;
  /* with SEAWAY_SHM_OWN_CAMERA, in place of a camera of the scene */
  double latitude_deg, longitude_deg;
  double eye_height;  /* m above the still-water level */
  double heading_deg; /* of the view, true */
  double pitch_deg;   /* up */
  double roll_deg;    /* right side down */
  double vertical_field_deg;
  uint8_t reserved_too[48];
} seaway_shm_picture_request;

/* 320 bytes */
typedef struct seaway_shm_picture_answer {
  uint32_t number; /* of the picture, as `pictures_asked` */
  uint32_t status;
  uint32_t width, height;
  double time;
  uint64_t colour_offset; /* in the slot: RGB, 8 bits a channel, rows from the top left */
  uint64_t depth_offset;  /* in the slot: floats, axial m, +inf for sky */
  uint8_t reserved[40];
  char message[SEAWAY_SHM_TEXT];
} seaway_shm_picture_answer;

/* Control words in lines of 64 bytes, by who writes them. */
typedef struct seaway_shm_slot {
  uint32_t session;      /* host: 0 none; else of this connection */
  uint32_t asked;        /* host: requests written; futex of the server */
  uint32_t client_waits; /* host: 1 while it may sleep on `answered` */
  uint32_t process;      /* host: its process number, for messages alone */
  uint32_t host_padding[12];
  uint32_t served;       /* server: the session that it serves; futex of the host */
  uint32_t answered;     /* server: requests answered; futex of the host */
  uint32_t server_waits; /* server: 1 while it may sleep on `asked` */
  uint32_t refusal;      /* server: why `served` has become 0, a seaway_shm_status */
  uint32_t server_padding[12];
  uint32_t pictures_asked; /* host: pictures asked for, one at a time */
  uint32_t picture_host_padding[15];
  uint32_t pictures_drawn; /* server: pictures answered; futex of the host */
  uint32_t picture_server_padding[15];
  seaway_shm_picture_request picture;
  seaway_shm_picture_answer drawn;
} seaway_shm_slot;

#endif
