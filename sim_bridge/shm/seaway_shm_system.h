/* What both sides of Seaway's shared memory ask of Linux: words to sleep on, locks that end with
 * their process, time. C11 and C++20. */
#ifndef SEAWAY_SHM_SYSTEM_H
#define SEAWAY_SHM_SYSTEM_H

#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* include this before the system's headers, or compile with -D_GNU_SOURCE */
#endif

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/futex.h>
#include <stdint.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#ifndef F_OFD_SETLK
#error "compile with -D_GNU_SOURCE, or include Seaway's headers before the system's"
#endif

static inline uint32_t seaway_shm_load(const uint32_t* word) {
  return __atomic_load_n(word, __ATOMIC_SEQ_CST);
}
static inline void seaway_shm_store(uint32_t* word, uint32_t value) {
  __atomic_store_n(word, value, __ATOMIC_SEQ_CST);
}

/* Sleeps while `word` is `value`, for at most `seconds`; may end early. */
static inline void seaway_shm_sleep(const uint32_t* word, uint32_t value, double seconds) {
  struct timespec limit;
  if (!(seconds > 0.0)) return;
  limit.tv_sec = (time_t)seconds;
  limit.tv_nsec = (long)(1e9 * (seconds - (double)limit.tv_sec));
  syscall(SYS_futex, word, FUTEX_WAIT, value, &limit, NULL, 0);
}
static inline void seaway_shm_wake(const uint32_t* word) {
  syscall(SYS_futex, word, FUTEX_WAKE, INT_MAX, NULL, NULL, 0);
}

/* A word is changed and those are woken who said that they may sleep: whoever sleeps sets its flag
 * before it looks at the word, so that one of the two sees the other (all sequentially consistent).
 */
static inline void seaway_shm_tell(uint32_t* word, uint32_t value, const uint32_t* waits) {
  seaway_shm_store(word, value);
  if (seaway_shm_load(waits)) seaway_shm_wake(word);
}

static inline void seaway_shm_pause(void) {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

/* s, monotonic */
static inline double seaway_shm_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Open-file-description locks of one byte; all 0 or -1 with errno. */
static inline int seaway_shm_lock_call(int file, uint32_t byte, int command, short type,
                                       short* found) {
  struct flock lock;
  int result;
  memset(&lock, 0, sizeof lock);
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = (off_t)byte;
  lock.l_len = 1;
  do {
    result = fcntl(file, command, &lock);
  } while (result != 0 && errno == EINTR);
  if (found) *found = lock.l_type;
  return result;
}
/* 1: the lock is ours now; 0: another's; -1: errno. */
static inline int seaway_shm_try_lock(int file, uint32_t byte) {
  if (seaway_shm_lock_call(file, byte, F_OFD_SETLK, F_WRLCK, NULL) == 0) return 1;
  return errno == EAGAIN || errno == EACCES ? 0 : -1;
}
static inline void seaway_shm_unlock(int file, uint32_t byte) {
  seaway_shm_lock_call(file, byte, F_OFD_SETLK, F_UNLCK, NULL);
}
/* Whether another open file holds the lock. */
static inline int seaway_shm_is_locked(int file, uint32_t byte) {
  short found = F_UNLCK;
  if (seaway_shm_lock_call(file, byte, F_OFD_GETLK, F_WRLCK, &found) != 0) return 1;
  return found != F_UNLCK;
}

#endif
