/* One height of a scene: consumer SCENE.yaml */
#include <math.h>
#include <seaway.h>
#include <stdio.h>

int main(int argc, char** argv) {
  seaway_sea* sea = NULL;
  if (argc != 2 || seaway_sea_from_file(argv[1], NULL, &sea) != SEAWAY_OK) {
    fprintf(stderr, "%s\n", seaway_last_error());
    return 2;
  }
  const double east = 3.0, north = 4.0;
  double height = NAN;
  seaway_points points = seaway_points_default();
  points.count = 1;
  points.first = &east;
  points.second = &north;
  seaway_samples samples = seaway_samples_default();
  samples.height = &height;
  const seaway_status status = seaway_sea_sample(sea, 1.0, &points, NULL, &samples);
  printf("Seaway %s: %.6f m\n", seaway_version(), height);
  seaway_sea_destroy(sea);
  return status != SEAWAY_OK || isnan(height);
}
