#include "sim_bridge/shm/segment.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include "sim_bridge/shm/seaway_shm_system.h"
#include "surface/input_error.h"

namespace seaway::bridge::shm {
namespace {

static_assert(sizeof(seaway_shm_header) == 192 && sizeof(seaway_shm_slot) == 768);
static_assert(sizeof(seaway_shm_request) == 128 && sizeof(seaway_shm_answer) == 384);
static_assert(sizeof(seaway_shm_pose) == 64);
static_assert(sizeof(seaway_shm_picture_request) == 192);
static_assert(sizeof(seaway_shm_picture_answer) == 320);

constexpr std::uint32_t serversByte = 0;
std::uint32_t hostsByte(std::uint32_t slot) { return 1 + slot; }

constexpr std::uint64_t roundedUp(std::uint64_t size, std::uint64_t unit) {
  return (size + unit - 1) / unit * unit;
}

/// A file descriptor that is closed.
class File {
 public:
  explicit File(int file) : file_(file) {}
  ~File() {
    if (file_ >= 0) close(file_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int get() const { return file_; }
  int take() { return std::exchange(file_, -1); }

 private:
  int file_;
};

void checkName(const std::string& option, const std::string& name) {
  const bool allowed =
      name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-") ==
      std::string::npos;
  if (name.empty() || name.size() > 200 || name[0] == '.' || !allowed) {
    throw InputError(option + ": '" + name +
                     "' is not allowed; must be 1 to 200 of A-Z a-z 0-9 . _ - and not begin with "
                     "a dot");
  }
}

[[noreturn]] void refuse(const std::string& option, const std::string& name,
                         const std::string& why) {
  throw InputError(option + ": '" + name + "': " + why);
}

/// Whether an existing segment may be replaced: one that a server of ours left behind, or had not
/// begun to fill in.
void requireOurs(int file, const std::string& option, const std::string& name) {
  struct stat about {};
  if (fstat(file, &about) != 0) refuse(option, name, std::strerror(errno));
  if (about.st_uid != geteuid()) refuse(option, name, "the shared memory is another user's");
  std::uint64_t magic = 0;
  const ssize_t size = pread(file, &magic, sizeof magic, 0);
  const bool ours = size <= 0 || magic == SEAWAY_SHM_MAGIC || magic == 0;
  if (!ours) {
    refuse(option, name,
           "there is shared memory of that name that is not Seaway's; use another name, or remove "
           "/dev/shm/" +
               name);
  }
}

/// Gives a file its size, and memory to the pages that hosts write before the server knows of them.
bool sized(int file, const seaway_shm_header& layout) {
  if (ftruncate(file, static_cast<off_t>(layout.segment_size)) != 0) return false;
  if (posix_fallocate(file, 0, SEAWAY_SHM_PAGE) != 0) return false;
  for (std::uint32_t i = 0; i < layout.slot_count; ++i) {
    const auto at = static_cast<off_t>(layout.slots_offset + i * layout.slot_size);
    if (posix_fallocate(file, at, SEAWAY_SHM_PAGE) != 0) return false;
  }
  return true;
}

/// Hosts that still look at a segment that is left behind learn that its server is gone.
void markEnded(int file) {
  const std::uint32_t ended = SEAWAY_SHM_ENDED;
  struct stat about {};
  if (fstat(file, &about) != 0 || about.st_size < static_cast<off_t>(SEAWAY_SHM_PAGE)) return;
  // They look every 50 ms; a write that fails changes no more than that.
  [[maybe_unused]] const ssize_t written =
      pwrite(file, &ended, sizeof ended, offsetof(seaway_shm_header, state));
}

}  // namespace

seaway_shm_header headerFor(const SegmentSettings& settings) {
  seaway_shm_header h{};
  h.version = SEAWAY_SHM_VERSION;
  h.header_size = sizeof h;
  h.slot_count = settings.slots;
  h.cell_count = settings.cells;
  h.point_limit = settings.points;
  h.pixel_limit = settings.pixels;
  h.arrays_offset = sizeof(seaway_shm_request) + sizeof(seaway_shm_answer);
  // Arrays an odd number of cache lines apart do not fall into the same sets of a cache.
  h.array_stride = roundedUp(8 * std::uint64_t{settings.points}, 128) + 64;
  h.cell_size = roundedUp(h.arrays_offset + (SEAWAY_SHM_ARRAYS + 1) * h.array_stride, 64);
  h.cells_offset = SEAWAY_SHM_PAGE;
  h.pixels_offset = roundedUp(h.cells_offset + h.cell_count * h.cell_size, SEAWAY_SHM_PAGE);
  h.slot_size =
      roundedUp(h.pixels_offset + 7 * std::uint64_t{settings.pixels} + 64, SEAWAY_SHM_PAGE);
  h.slots_offset = SEAWAY_SHM_PAGE;
  h.segment_size = h.slots_offset + h.slot_count * h.slot_size;
  return h;
}

Segment::Segment(const std::string& option, const std::string& name,
                 const SegmentSettings& settings)
    : name_(name), layout_(headerFor(settings)) {
  checkName(option, name);
  std::random_device random;
  layout_.server_number = (std::uint64_t{random()} << 32) | random();
  makeFile(option);
  const auto size = static_cast<std::size_t>(layout_.segment_size);
  void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
  if (memory == MAP_FAILED) {
    close(file_);
    throw std::system_error(errno, std::generic_category(), "shared memory " + name);
  }
  memory_ = static_cast<std::byte*>(memory);
  guard_.emplace(memory_, size);
  std::memcpy(memory_, &layout_, sizeof layout_);
}

Segment::~Segment() {
  end();
  const File named(shm_open(("/" + name_).c_str(), O_RDWR, 0));
  struct stat theirs {
  }, ours{};
  const bool same = named.get() >= 0 && fstat(named.get(), &theirs) == 0 &&
                    fstat(file_, &ours) == 0 && theirs.st_ino == ours.st_ino;
  if (same) shm_unlink(("/" + name_).c_str());
  guard_.reset();
  munmap(memory_, static_cast<std::size_t>(layout_.segment_size));
  close(file_);
}

/// Whoever holds the lock of a file that still has the name may take the name away; whoever makes
/// the file that comes next and locks it has the name. So of several that start at once one wins.
void Segment::makeFile(const std::string& option) {
  const std::string path = "/" + name_;
  const char* inUse = "in use by another server; end it, or use another name";
  for (int attempt = 0; attempt < 100; ++attempt) {
    File made(shm_open(path.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600));
    if (made.get() >= 0) {
      if (seaway_shm_try_lock(made.get(), serversByte) != 1) refuse(option, name_, inUse);
      fchmod(made.get(), 0600);
      if (!sized(made.get(), layout_)) {
        shm_unlink(path.c_str());
        refuse(option, name_, "the machine's shared memory is used up");
      }
      file_ = made.take();
      return;
    }
    if (errno != EEXIST) refuse(option, name_, std::strerror(errno));
    const File old(shm_open(path.c_str(), O_RDWR, 0));
    if (old.get() < 0 && errno == ENOENT) continue;
    if (old.get() < 0) refuse(option, name_, std::strerror(errno));
    if (seaway_shm_try_lock(old.get(), serversByte) != 1) refuse(option, name_, inUse);
    const File again(shm_open(path.c_str(), O_RDWR, 0));
    struct stat first {
    }, second{};
    const bool same = again.get() >= 0 && fstat(old.get(), &first) == 0 &&
                      fstat(again.get(), &second) == 0 && first.st_ino == second.st_ino;
    if (!same) continue;
    requireOurs(old.get(), option, name_);
    markEnded(old.get());
    shm_unlink(path.c_str());
  }
  refuse(option, name_, inUse);
}

std::byte* Segment::slotMemory(std::uint32_t number) const {
  return memory_ + layout_.slots_offset + number * layout_.slot_size;
}

seaway_shm_header& Segment::header() const {
  return *reinterpret_cast<seaway_shm_header*>(memory_);
}

seaway_shm_slot& Segment::slot(std::uint32_t number) const {
  return *reinterpret_cast<seaway_shm_slot*>(slotMemory(number));
}

std::byte* Segment::cell(std::uint32_t slot, std::uint32_t request) const {
  return slotMemory(slot) + layout_.cells_offset +
         ((request - 1) % layout_.cell_count) * layout_.cell_size;
}

std::byte* Segment::pixels(std::uint32_t slot) const {
  return slotMemory(slot) + layout_.pixels_offset;
}

void Segment::open() {
  seaway_shm_store(&header().state, SEAWAY_SHM_SERVING);
  __atomic_store_n(&header().magic, SEAWAY_SHM_MAGIC, __ATOMIC_SEQ_CST);
}

bool Segment::sound() const noexcept {
  seaway_shm_header expected = layout_;
  expected.magic = SEAWAY_SHM_MAGIC;
  constexpr std::size_t fixed = offsetof(seaway_shm_header, state);
  return !broken() && std::memcmp(&header(), &expected, fixed) == 0 &&
         seaway_shm_load(&header().state) == SEAWAY_SHM_SERVING;
}

void Segment::end() {
  seaway_shm_store(&header().state, SEAWAY_SHM_ENDED);
  if (broken()) return;
  for (std::uint32_t i = 0; i < layout_.slot_count; ++i) {
    seaway_shm_slot& each = slot(i);
    seaway_shm_wake(&each.served);
    seaway_shm_wake(&each.answered);
    seaway_shm_wake(&each.pictures_drawn);
  }
}

bool Segment::reserveRing(std::uint32_t slot) const {
  const auto from = layout_.slots_offset + slot * layout_.slot_size;
  return posix_fallocate(file_, static_cast<off_t>(from),
                         static_cast<off_t>(layout_.pixels_offset)) == 0;
}

bool Segment::reservePixels(std::uint32_t slot, std::size_t bytes) const {
  const auto from = layout_.slots_offset + slot * layout_.slot_size + layout_.pixels_offset;
  return posix_fallocate(file_, static_cast<off_t>(from), static_cast<off_t>(bytes)) == 0;
}

void Segment::release(std::uint32_t slot) const {
  const auto from = layout_.slots_offset + slot * layout_.slot_size + SEAWAY_SHM_PAGE;
  fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(from),
            static_cast<off_t>(layout_.slot_size - SEAWAY_SHM_PAGE));
}

bool Segment::tryLock(std::uint32_t slot) const {
  return seaway_shm_try_lock(file_, hostsByte(slot)) == 1;
}

void Segment::unlock(std::uint32_t slot) const { seaway_shm_unlock(file_, hostsByte(slot)); }

}  // namespace seaway::bridge::shm
