#include <seaway.h>

#include <iostream>

int main() {
  std::cout << "Seaway " << seaway_version() << '\n';
  return seaway_samples_default().struct_size == sizeof(seaway_samples) ? 0 : 1;
}
