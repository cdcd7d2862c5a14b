/* Asks a sea that `seaway serve SCENE --shm NAME` serves on this machine: C11 or C++20, header
 * only, Linux. Copy seaway_shm.h, seaway_shm_layout.h and seaway_shm_system.h; nothing is linked.
 *
 *   seaway_shm_client sea;
 *   if (seaway_shm_connect(&sea, "sea", NULL) != SEAWAY_SHM_OK) return 1;
 *   seaway_shm_batch batch;
 *   seaway_shm_begin(&sea, SEAWAY_SHM_SAMPLE, &batch);
 *   batch.request->time = t;  batch.request->count = n;  batch.x[0] = ..;  batch.y[0] = ..;
 *   seaway_shm_submit(&sea, &batch);                (other work)
 *   if (seaway_shm_wait(&sea, &batch, 0.1) == SEAWAY_SHM_OK) use(batch.height[0]);
 *   seaway_shm_disconnect(&sea);
 *
 * Calls never block longer than their timeout. A server that ended or was killed is told within
 * 0.1 s to whoever waits, as SEAWAY_SHM_SERVER_GONE; then seaway_shm_reconnect. Hulls are
 * gone with the connection, whichever side ended it, and have to be added again.
 *
 * A client is for one thread at a time; connect once for each thread. It must not be used on both
 * sides of a fork, and while a forked child lives that has not called exec, the server takes its
 * parent's connections to be alive. */
#ifndef SEAWAY_SHM_H
#define SEAWAY_SHM_H

#include "seaway_shm_system.h"
/* system.h before all others: it asks for GNU's declarations. */
#include <math.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "seaway_shm_layout.h"

typedef struct seaway_shm_options {
  double connect_timeout; /* s; how long connect and reconnect look for a server with room */
  double call_timeout;    /* s; of calls without a timeout of their own */
  double spin;            /* s that a wait looks at the answer before it sleeps */
} seaway_shm_options;

static inline seaway_shm_options seaway_shm_default_options(void) {
  seaway_shm_options options;
  options.connect_timeout = 1.0;
  options.call_timeout = 1.0;
  options.spin = 200e-6; /* the evaluation of some 2000 points */
  return options;
}

/* Not connected where `header` is null, as after setting all of it to 0. */
typedef struct seaway_shm_client {
  seaway_shm_header* header;
  seaway_shm_slot* slot;
  seaway_shm_header layout; /* checked copy of the header */
  int file;
  uint32_t slot_number, session, asked;
  int server_gone;
  seaway_shm_options options;
  char name[256];
  char message[SEAWAY_SHM_TEXT]; /* of the last call that was not OK */
} seaway_shm_client;

/* A request and its answer in the shared memory. Answers hold until seaway_shm_begin has been
 * called layout.cell_count times again. */
typedef struct seaway_shm_batch {
  uint32_t number;
  seaway_shm_request* request;
  const seaway_shm_answer* answer;
  double *x, *y; /* room for layout.point_limit, as all arrays */
  const double *height, *slope_east, *slope_north, *vertical_velocity;
  const double *orbital_east, *orbital_north, *orbital_up, *error, *bound;
  const uint32_t* status;
  unsigned char* bytes; /* where poses are written and text is read */
} seaway_shm_batch;

typedef struct seaway_shm_picture {
  uint32_t width, height;
  double time;
  const unsigned char* rgb; /* width * height * 3, rows from the top left */
  const float* depth;       /* width * height, axial m, +inf for sky */
} seaway_shm_picture;

static inline const char* seaway_shm_status_text(seaway_shm_status status) {
  static const char* const texts[] = {"ok",        "timeout",       "no server",     "server gone",
                                      "no slot",   "wrong version", "not connected", "ring full",
                                      "too large", "bad value",     "not found",     "malformed",
                                      "no memory", "failed"};
  const unsigned number = (unsigned)status;
  return number < sizeof texts / sizeof texts[0] ? texts[number] : "unknown";
}

static inline seaway_shm_status seaway_shm_fail(seaway_shm_client* client, seaway_shm_status status,
                                                const char* message) {
  snprintf(client->message, sizeof client->message, "%s", message);
  return status;
}

/* Whether a header's numbers fit each other and a file of `size` bytes. */
static inline int seaway_shm_layout_fits(const seaway_shm_header* h, uint64_t size) {
  const uint64_t page = SEAWAY_SHM_PAGE, most = UINT64_C(1) << 46;
  const uint64_t sizes[] = {h->slots_offset,  h->slot_size,    h->cells_offset, h->cell_size,
                            h->arrays_offset, h->array_stride, h->pixels_offset};
  unsigned i;
  for (i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
    if (sizes[i] == 0 || sizes[i] > most || sizes[i] % 64 != 0) return 0;
  }
  if (h->header_size != sizeof(seaway_shm_header) || h->segment_size != size) return 0;
  if (h->slots_offset % page != 0 || h->slot_size % page != 0) return 0;
  if (h->slots_offset < page || h->cells_offset < sizeof(seaway_shm_slot)) return 0;
  if (h->slot_count == 0 || h->slot_count > 4096 || h->point_limit == 0) return 0;
  if (h->cell_count == 0 || h->cell_count > 1024 || (h->cell_count & (h->cell_count - 1)) != 0)
    return 0;
  if (h->arrays_offset < sizeof(seaway_shm_request) + sizeof(seaway_shm_answer)) return 0;
  if (h->array_stride < 8 * (uint64_t)h->point_limit) return 0;
  if (h->cell_size < h->arrays_offset + (SEAWAY_SHM_ARRAYS + 1) * h->array_stride) return 0;
  if (h->pixels_offset < h->cells_offset + h->cell_count * h->cell_size) return 0;
  if (h->slot_size < h->pixels_offset + 7 * (uint64_t)h->pixel_limit + 64) return 0;
  return h->slots_offset + h->slot_count * h->slot_size <= size;
}

static inline void seaway_shm_close(seaway_shm_client* client) {
  if (client->slot) munmap(client->slot, (size_t)client->layout.slot_size);
  if (client->header) munmap(client->header, SEAWAY_SHM_PAGE);
  if (client->file >= 0) close(client->file); /* lets go of the slot's lock */
  client->slot = NULL;
  client->header = NULL;
  client->file = -1;
}

/* Opens the segment and checks it. */
static inline seaway_shm_status seaway_shm_open_segment(seaway_shm_client* client) {
  char path[260];
  struct stat about;
  void* memory;
  snprintf(path, sizeof path, "/%s", client->name);
  client->file = shm_open(path, O_RDWR, 0);
  if (client->file < 0) {
    if (errno == ENOENT) {
      return seaway_shm_fail(client, SEAWAY_SHM_NO_SERVER, "nobody serves under that name");
    }
    return seaway_shm_fail(client, SEAWAY_SHM_FAILED, strerror(errno));
  }
  if (fstat(client->file, &about) != 0 || about.st_size < (off_t)SEAWAY_SHM_PAGE) {
    return seaway_shm_fail(client, SEAWAY_SHM_NO_SERVER, "the server is not ready");
  }
  if (about.st_uid != geteuid()) {
    return seaway_shm_fail(client, SEAWAY_SHM_FAILED, "the segment is another user's");
  }
  memory = mmap(NULL, SEAWAY_SHM_PAGE, PROT_READ | PROT_WRITE, MAP_SHARED, client->file, 0);
  if (memory == MAP_FAILED) return seaway_shm_fail(client, SEAWAY_SHM_FAILED, strerror(errno));
  client->header = (seaway_shm_header*)memory;
  if (__atomic_load_n(&client->header->magic, __ATOMIC_SEQ_CST) == 0) {
    return seaway_shm_fail(client, SEAWAY_SHM_NO_SERVER, "the server is not ready");
  }
  memcpy(&client->layout, client->header, sizeof client->layout);
  if (client->layout.magic != SEAWAY_SHM_MAGIC || client->layout.version != SEAWAY_SHM_VERSION ||
      !seaway_shm_layout_fits(&client->layout, (uint64_t)about.st_size)) {
    return seaway_shm_fail(client, SEAWAY_SHM_WRONG_VERSION,
                           "the segment is not Seaway's, or of another version");
  }
  if (seaway_shm_load(&client->header->state) != SEAWAY_SHM_SERVING ||
      !seaway_shm_is_locked(client->file, 0)) {
    return seaway_shm_fail(client, SEAWAY_SHM_NO_SERVER, "the server has ended");
  }
  return SEAWAY_SHM_OK;
}

/* Takes a slot of its own and says so. */
static inline seaway_shm_status seaway_shm_take_slot(seaway_shm_client* client) {
  const seaway_shm_header* layout = &client->layout;
  const uint64_t now = (uint64_t)(1e9 * seaway_shm_now());
  void* memory;
  uint32_t i = 0, session;
  while (i < layout->slot_count && seaway_shm_try_lock(client->file, 1 + i) != 1) ++i;
  if (i == layout->slot_count) {
    return seaway_shm_fail(client, SEAWAY_SHM_NO_SLOT, "all slots are taken");
  }
  memory = mmap(NULL, (size_t)layout->slot_size, PROT_READ | PROT_WRITE, MAP_SHARED, client->file,
                (off_t)(layout->slots_offset + i * layout->slot_size));
  if (memory == MAP_FAILED) return seaway_shm_fail(client, SEAWAY_SHM_FAILED, strerror(errno));
  client->slot = (seaway_shm_slot*)memory;
  client->slot_number = i;
  client->asked = 0;
  /* Other than that of whoever had the slot before. */
  session = (uint32_t)(now ^ (now >> 32)) ^ (uint32_t)getpid() * 2654435761u;
  while (session == 0 || session == seaway_shm_load(&client->slot->session) ||
         session == seaway_shm_load(&client->slot->served)) {
    ++session;
  }
  client->session = session;
  seaway_shm_store(&client->slot->session, 0);
  client->slot->process = (uint32_t)getpid();
  seaway_shm_store(&client->slot->asked, 0);
  seaway_shm_store(&client->slot->client_waits, 0);
  seaway_shm_store(&client->slot->pictures_asked, 0);
  seaway_shm_store(&client->slot->session, session);
  seaway_shm_wake(&client->slot->asked);
  __atomic_add_fetch(&client->header->attention, 1, __ATOMIC_SEQ_CST);
  seaway_shm_wake(&client->header->attention);
  return SEAWAY_SHM_OK;
}

/* Why there will be no answer; OK where there may be one. */
static inline seaway_shm_status seaway_shm_health(seaway_shm_client* client, int ask_system) {
  if (seaway_shm_load(&client->header->state) != SEAWAY_SHM_SERVING) client->server_gone = 1;
  if (ask_system && !seaway_shm_is_locked(client->file, 0)) client->server_gone = 1;
  if (client->server_gone) {
    return seaway_shm_fail(client, SEAWAY_SHM_SERVER_GONE, "the server has ended or died");
  }
  if (seaway_shm_load(&client->slot->served) == client->session) {
    const uint32_t refusal = seaway_shm_load(&client->slot->refusal);
    if (refusal != SEAWAY_SHM_OK) {
      return seaway_shm_fail(client, (seaway_shm_status)refusal,
                             refusal == SEAWAY_SHM_NO_MEMORY
                                 ? "the machine's shared memory is used up"
                                 : "the server has ended this connection");
    }
  }
  return SEAWAY_SHM_OK;
}

/* Waits until `word` is `number` or, counting on, beyond it. */
static inline seaway_shm_status seaway_shm_await(seaway_shm_client* client, const uint32_t* word,
                                                 uint32_t number, int exactly, double spin,
                                                 double timeout) {
  const double slice = 0.05;
  const double start = seaway_shm_now();
  double now = start;
  for (;;) {
    seaway_shm_status health;
    uint32_t value = seaway_shm_load(word);
    int late;
    if (exactly ? value == number : (int32_t)(value - number) >= 0) return SEAWAY_SHM_OK;
    if (now - start < spin && now - start < timeout) {
      /* Little of the core, which the server may share. */
      int i;
      for (i = 0; i < 4 && seaway_shm_load(word) == value; ++i) seaway_shm_pause();
      now = seaway_shm_now();
      continue;
    }
    seaway_shm_store(&client->slot->client_waits, 1);
    late = now - start >= timeout;
    health = seaway_shm_health(client, late || now - start >= slice);
    value = seaway_shm_load(word);
    if (exactly ? value == number : (int32_t)(value - number) >= 0)
      health = SEAWAY_SHM_OK;
    else if (health == SEAWAY_SHM_OK && late)
      health = seaway_shm_fail(client, SEAWAY_SHM_TIMEOUT, "no answer in the time given");
    else if (health == SEAWAY_SHM_OK) {
      const double left = timeout - (now - start);
      seaway_shm_sleep(word, value, left < slice ? left : slice);
      now = seaway_shm_now();
      continue;
    }
    seaway_shm_store(&client->slot->client_waits, 0);
    return health;
  }
}

static inline void seaway_shm_disconnect(seaway_shm_client* client) {
  if (!client->header) return;
  if (client->slot) {
    seaway_shm_store(&client->slot->session, 0);
    seaway_shm_wake(&client->slot->asked);
  }
  seaway_shm_close(client);
}

/* Connects anew under the same name and options; the old connection is ended. */
static inline seaway_shm_status seaway_shm_reconnect(seaway_shm_client* client) {
  const double start = seaway_shm_now(), limit = client->options.connect_timeout;
  seaway_shm_disconnect(client);
  for (;;) {
    double left = limit - (seaway_shm_now() - start);
    seaway_shm_status status = seaway_shm_open_segment(client);
    client->server_gone = 0;
    if (status == SEAWAY_SHM_OK) status = seaway_shm_take_slot(client);
    if (status == SEAWAY_SHM_OK) {
      status = seaway_shm_await(client, &client->slot->served, client->session, 1, 0.0,
                                left > 0.01 ? left : 0.01);
    }
    if (status == SEAWAY_SHM_OK) status = seaway_shm_health(client, 0);
    if (status == SEAWAY_SHM_OK) return status;
    left = limit - (seaway_shm_now() - start);
    if (status == SEAWAY_SHM_NO_SLOT && left <= 0.0) {
      __atomic_add_fetch(&client->header->turned_away, 1, __ATOMIC_SEQ_CST);
    }
    seaway_shm_close(client);
    if ((status != SEAWAY_SHM_NO_SERVER && status != SEAWAY_SHM_NO_SLOT &&
         status != SEAWAY_SHM_SERVER_GONE) ||
        left <= 0.0) {
      return status;
    } else {
      const struct timespec pause = {0, 5000000};
      nanosleep(&pause, NULL);
    }
  }
}

/* Connects to `seaway serve .. --shm name`; `options` null: the default. `client` need not be
 * initialised. Looks for a server with a free slot until the timeout. */
static inline seaway_shm_status seaway_shm_connect(seaway_shm_client* client, const char* name,
                                                   const seaway_shm_options* options) {
  memset(client, 0, sizeof *client);
  client->file = -1;
  client->options = options ? *options : seaway_shm_default_options();
  if (!name || !*name || strlen(name) >= sizeof client->name || strchr(name, '/')) {
    return seaway_shm_fail(client, SEAWAY_SHM_BAD_VALUE, "a name of 1 to 255 bytes without '/'");
  }
  snprintf(client->name, sizeof client->name, "%s", name);
  return seaway_shm_reconnect(client);
}

/* The next request, all 0 but its kind; fill in, then submit. */
static inline seaway_shm_status seaway_shm_begin(seaway_shm_client* client, uint32_t kind,
                                                 seaway_shm_batch* batch) {
  const seaway_shm_header* layout = &client->layout;
  seaway_shm_status health;
  unsigned char *cell, *arrays;
  if (!client->header) {
    return seaway_shm_fail(client, SEAWAY_SHM_NOT_CONNECTED, "not connected");
  }
  health = seaway_shm_health(client, 0);
  if (health != SEAWAY_SHM_OK) return health;
  if (client->asked - seaway_shm_load(&client->slot->answered) >= layout->cell_count) {
    return seaway_shm_fail(client, SEAWAY_SHM_RING_FULL, "wait for the oldest request first");
  }
  batch->number = client->asked + 1;
  cell = (unsigned char*)client->slot + layout->cells_offset +
         (client->asked % layout->cell_count) * layout->cell_size;
  arrays = cell + layout->arrays_offset;
  batch->request = (seaway_shm_request*)cell;
  batch->answer = (const seaway_shm_answer*)(cell + sizeof(seaway_shm_request));
  batch->bytes = arrays;
#define SEAWAY_SHM_ARRAY(index) (double*)(arrays + (index)*layout->array_stride)
  batch->x = SEAWAY_SHM_ARRAY(SEAWAY_SHM_X);
  batch->y = SEAWAY_SHM_ARRAY(SEAWAY_SHM_Y);
  batch->height = SEAWAY_SHM_ARRAY(SEAWAY_SHM_HEIGHT);
  batch->slope_east = SEAWAY_SHM_ARRAY(SEAWAY_SHM_SLOPE_EAST);
  batch->slope_north = SEAWAY_SHM_ARRAY(SEAWAY_SHM_SLOPE_NORTH);
  batch->vertical_velocity = SEAWAY_SHM_ARRAY(SEAWAY_SHM_VERTICAL_VELOCITY);
  batch->orbital_east = SEAWAY_SHM_ARRAY(SEAWAY_SHM_ORBITAL_EAST);
  batch->orbital_north = SEAWAY_SHM_ARRAY(SEAWAY_SHM_ORBITAL_NORTH);
  batch->orbital_up = SEAWAY_SHM_ARRAY(SEAWAY_SHM_ORBITAL_UP);
  batch->error = SEAWAY_SHM_ARRAY(SEAWAY_SHM_ERROR);
  batch->bound = SEAWAY_SHM_ARRAY(SEAWAY_SHM_BOUND);
#undef SEAWAY_SHM_ARRAY
  batch->status = (const uint32_t*)(arrays + SEAWAY_SHM_ARRAYS * layout->array_stride);
  memset(batch->request, 0, sizeof *batch->request);
  batch->request->number = batch->number;
  batch->request->kind = kind;
  return SEAWAY_SHM_OK;
}

/* Hands over what begin gave; returns at once. */
static inline void seaway_shm_submit(seaway_shm_client* client, const seaway_shm_batch* batch) {
  client->asked = batch->number;
  seaway_shm_tell(&client->slot->asked, batch->number, &client->slot->server_waits);
}

/* Waits for an answer; `timeout` in s. After SEAWAY_SHM_TIMEOUT one may wait again. */
static inline seaway_shm_status seaway_shm_wait(seaway_shm_client* client,
                                                const seaway_shm_batch* batch, double timeout) {
  seaway_shm_status status;
  if (!client->header) {
    return seaway_shm_fail(client, SEAWAY_SHM_NOT_CONNECTED, "not connected");
  }
  status = seaway_shm_await(client, &client->slot->answered, batch->number, 0, client->options.spin,
                            timeout);
  if (status != SEAWAY_SHM_OK) return status;
  if (batch->answer->number != batch->number) {
    return seaway_shm_fail(client, SEAWAY_SHM_MALFORMED, "the answer is another request's");
  }
  status = (seaway_shm_status)batch->answer->status;
  if (status != SEAWAY_SHM_OK) {
    memcpy(client->message, batch->answer->message, sizeof client->message);
    client->message[sizeof client->message - 1] = 0;
  }
  return status;
}

static inline seaway_shm_status seaway_shm_call(seaway_shm_client* client,
                                                const seaway_shm_batch* batch) {
  seaway_shm_submit(client, batch);
  return seaway_shm_wait(client, batch, client->options.call_timeout);
}

/* Asks for the water at `count` points and waits; the answer is in `batch`. `how` gives flags,
 * time, tolerance, shortest_wavelength and own_hull. */
static inline seaway_shm_status seaway_shm_sample(seaway_shm_client* client,
                                                  const seaway_shm_request* how, const double* x,
                                                  const double* y, uint32_t count,
                                                  seaway_shm_batch* batch) {
  seaway_shm_status status = seaway_shm_begin(client, SEAWAY_SHM_SAMPLE, batch);
  if (status != SEAWAY_SHM_OK) return status;
  if (count > client->layout.point_limit) {
    snprintf(client->message, sizeof client->message, "%u points; at most %u at once",
             (unsigned)count, (unsigned)client->layout.point_limit);
    return SEAWAY_SHM_TOO_LARGE;
  }
  *batch->request = *how;
  batch->request->number = batch->number;
  batch->request->kind = SEAWAY_SHM_SAMPLE;
  batch->request->count = count;
  if (count > 0) {
    memcpy(batch->x, x, count * sizeof *x);
    memcpy(batch->y, y, count * sizeof *y);
  }
  return seaway_shm_call(client, batch);
}

/* A hull of the scene's vessel `vessel`, from 0 on, that this host sails: *hull. */
static inline seaway_shm_status seaway_shm_add_hull(seaway_shm_client* client, uint32_t vessel,
                                                    uint32_t* hull) {
  seaway_shm_batch batch;
  seaway_shm_status status = seaway_shm_begin(client, SEAWAY_SHM_ADD_HULL, &batch);
  if (status != SEAWAY_SHM_OK) return status;
  batch.request->vessel = vessel;
  status = seaway_shm_call(client, &batch);
  if (status == SEAWAY_SHM_OK) *hull = batch.answer->hull;
  return status;
}

static inline seaway_shm_status seaway_shm_remove_hull(seaway_shm_client* client, uint32_t hull) {
  seaway_shm_batch batch;
  seaway_shm_status status = seaway_shm_begin(client, SEAWAY_SHM_REMOVE_HULL, &batch);
  if (status != SEAWAY_SHM_OK) return status;
  batch.request->hull = hull;
  return seaway_shm_call(client, &batch);
}

/* Where hulls are at a time; before the epoch they leave no trail. */
static inline seaway_shm_status seaway_shm_place_hulls(seaway_shm_client* client, double time,
                                                       const seaway_shm_pose* poses,
                                                       uint32_t count) {
  seaway_shm_batch batch;
  seaway_shm_status status = seaway_shm_begin(client, SEAWAY_SHM_PLACE_HULLS, &batch);
  if (status != SEAWAY_SHM_OK) return status;
  if (count * (uint64_t)sizeof *poses > client->layout.array_stride) {
    return seaway_shm_fail(client, SEAWAY_SHM_TOO_LARGE, "too many poses at once");
  }
  batch.request->time = time;
  batch.request->count = count;
  if (count > 0) memcpy(batch.bytes, poses, count * sizeof *poses);
  return seaway_shm_call(client, &batch);
}

/* JSON text about the sea into `text`, cut to `size` bytes with its final 0; *length: of it all. */
static inline seaway_shm_status seaway_shm_describe(seaway_shm_client* client, char* text,
                                                    size_t size, size_t* length) {
  seaway_shm_batch batch;
  seaway_shm_status status = seaway_shm_begin(client, SEAWAY_SHM_DESCRIBE, &batch);
  size_t whole, part;
  if (status == SEAWAY_SHM_OK) status = seaway_shm_call(client, &batch);
  if (status != SEAWAY_SHM_OK) return status;
  whole = batch.answer->text_size;
  if (whole > client->layout.cell_size - client->layout.arrays_offset) {
    return seaway_shm_fail(client, SEAWAY_SHM_MALFORMED, "a text longer than its place");
  }
  if (length) *length = whole;
  part = size == 0 ? 0 : whole < size - 1 ? whole : size - 1;
  if (part > 0) memcpy(text, batch.bytes, part);
  if (size > 0) text[part] = 0;
  return SEAWAY_SHM_OK;
}

/* Asks for a picture and returns at once; one at a time. Samples go on meanwhile. */
static inline seaway_shm_status seaway_shm_ask_picture(seaway_shm_client* client,
                                                       const seaway_shm_picture_request* picture) {
  seaway_shm_status health;
  uint32_t number;
  if (!client->header) {
    return seaway_shm_fail(client, SEAWAY_SHM_NOT_CONNECTED, "not connected");
  }
  health = seaway_shm_health(client, 0);
  if (health != SEAWAY_SHM_OK) return health;
  number = seaway_shm_load(&client->slot->pictures_asked);
  if (number != seaway_shm_load(&client->slot->pictures_drawn)) {
    return seaway_shm_fail(client, SEAWAY_SHM_RING_FULL, "wait for the picture asked before");
  }
  client->slot->picture = *picture;
  seaway_shm_store(&client->slot->pictures_asked, number + 1);
  __atomic_add_fetch(&client->header->pictures_asked, 1, __ATOMIC_SEQ_CST);
  seaway_shm_wake(&client->header->pictures_asked);
  return SEAWAY_SHM_OK;
}

/* Waits for the picture asked for; it holds until the next is asked. */
static inline seaway_shm_status seaway_shm_wait_picture(seaway_shm_client* client,
                                                        seaway_shm_picture* picture,
                                                        double timeout) {
  const unsigned char* base = (const unsigned char*)client->slot;
  seaway_shm_picture_answer drawn;
  seaway_shm_status status;
  uint64_t pixels;
  if (!client->header) {
    return seaway_shm_fail(client, SEAWAY_SHM_NOT_CONNECTED, "not connected");
  }
  status = seaway_shm_await(client, &client->slot->pictures_drawn,
                            seaway_shm_load(&client->slot->pictures_asked), 1, 0.0, timeout);
  if (status != SEAWAY_SHM_OK) return status;
  drawn = client->slot->drawn;
  if (drawn.status != SEAWAY_SHM_OK) {
    memcpy(client->message, drawn.message, sizeof client->message);
    client->message[sizeof client->message - 1] = 0;
    return (seaway_shm_status)drawn.status;
  }
  pixels = (uint64_t)drawn.width * drawn.height;
  if (pixels > client->layout.pixel_limit || drawn.depth_offset % sizeof(float) != 0 ||
      drawn.colour_offset > client->layout.slot_size - 3 * pixels ||
      drawn.depth_offset > client->layout.slot_size - 4 * pixels) {
    return seaway_shm_fail(client, SEAWAY_SHM_MALFORMED, "a picture beyond its place");
  }
  picture->width = drawn.width;
  picture->height = drawn.height;
  picture->time = drawn.time;
  picture->rgb = base + drawn.colour_offset;
  picture->depth = (const float*)(const void*)(base + drawn.depth_offset);
  return SEAWAY_SHM_OK;
}

#endif
