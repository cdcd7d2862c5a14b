/* Asks a scene's sea for the water under three points of a hull, through the C interface:
 *   cc -std=c11 query_height.c $(pkg-config --cflags --libs seaway) && ./a.out SCENE.yaml */
#include <seaway.h>
#include <stdio.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: %s SCENE.yaml\n", argv[0]);
    return 2;
  }
  seaway_sea* sea = NULL;
  if (seaway_sea_from_file(argv[1], NULL, &sea) != SEAWAY_OK) {
    fprintf(stderr, "%s\n", seaway_last_error());
    return 2;
  }

  const double east[] = {0.0, 10.0, 20.0}; /* m from the scene's anchor */
  const double north[] = {0.0, 0.0, 0.0};
  double height[3], error[3], up[3];
  uint32_t status[3];

  seaway_points points = seaway_points_default();
  points.count = 3;
  points.first = east;
  points.second = north;
  seaway_sample_options options = seaway_sample_options_default();
  options.tolerance = 0.01; /* m that may be left out */
  seaway_samples samples = seaway_samples_default();
  samples.height = height;
  samples.error = error;
  samples.vertical_velocity = up;
  samples.status = status;

  int failed = 0;
  for (double t = 0.0; t < 2.0 && !failed; t += 0.5) {
    failed = seaway_sea_step_to(sea, t) != SEAWAY_OK ||
             seaway_sea_sample(sea, t, &points, &options, &samples) != SEAWAY_OK;
    for (int i = 0; i < 3 && !failed; ++i) {
      printf("%4.1f s, %4.1f m east: %+.3f m +- %.3f m, %+.3f m/s, status %u\n", t, east[i],
             height[i], error[i], up[i], (unsigned)status[i]);
    }
  }
  if (failed) fprintf(stderr, "%s\n", seaway_last_error());
  seaway_sea_destroy(sea);
  return failed;
}
