/* A host in C: asks a sea that another process serves for the water under four points of a hull.
 *   seaway serve configs/scenes/canaveral.yaml --shm sea &
 *   shm_host sea */
#include "sim_bridge/shm/seaway_shm.h"

int main(int argc, char** argv) {
  const double x[] = {-5.0, -5.0, 5.0, 5.0}, y[] = {-2.0, 2.0, -2.0, 2.0};
  seaway_shm_options options = seaway_shm_default_options();
  seaway_shm_client sea;
  seaway_shm_status status;
  int step;
  options.connect_timeout = 20.0; /* s */
  status = seaway_shm_connect(&sea, argc > 1 ? argv[1] : "sea", &options);
  for (step = 0; status == SEAWAY_SHM_OK && step < 5; ++step) {
    seaway_shm_request how = {0};
    seaway_shm_batch batch;
    how.time = 0.5 * step;
    how.tolerance = 0.01; /* m */
    status = seaway_shm_sample(&sea, &how, x, y, 4, &batch);
    if (status != SEAWAY_SHM_OK) break;
    printf("%.1f s: %+.3f %+.3f %+.3f %+.3f m, +- %.3f m\n", how.time, batch.height[0],
           batch.height[1], batch.height[2], batch.height[3], batch.error[0]);
  }
  if (status == SEAWAY_SHM_OK) {
    seaway_shm_disconnect(&sea);
    return 0;
  }
  fprintf(stderr, "%s: %s\n", seaway_shm_status_text(status), sea.message);
  return 1;
}
