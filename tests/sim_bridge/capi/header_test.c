/* The header alone, as C11 reads it: compiled with every warning an error. Linked into the tests
 * so that it is not forgotten. */
#include <seaway.h>

int seaway_test_header_compiles(void);
int seaway_test_header_compiles(void) {
  const seaway_points points = seaway_points_default();
  const seaway_camera camera = seaway_camera_default();
  return points.struct_size == sizeof points && camera.field_of_view_deg > 0.0;
}
