/* Faults inside a service, loaded with LD_PRELOAD: a disk that hangs or fails, and a wall clock that jumps.

   FAULTS_FILE names a file of four 64-bit numbers that the test changes while the service runs:
   0: whether writes and syncs below FAULTS_FOLDER wait, 1: the error they end with, 0 for none,
   2: seconds that the wall clock is ahead, 3: how many writes and syncs have been held up so far. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static volatile int64_t *faults;
static const char *folder;

__attribute__((constructor)) static void begin(void) {
    const char *name = getenv("FAULTS_FILE");
    int file = name ? open(name, O_RDWR) : -1;
    folder = getenv("FAULTS_FOLDER");
    if (file < 0) return;
    void *mapped = mmap(NULL, 32, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped != MAP_FAILED) faults = mapped;
    close(file);
}

/* Whether a call on this descriptor fails; waits as long as the disk hangs. */
static int fails(int descriptor) {
    char link[64], path[4096];
    if (!faults || !folder || !(faults[0] || faults[1])) return 0;
    snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    ssize_t size = readlink(link, path, sizeof path - 1);
    if (size < 0 || strncmp(path, folder, strlen(folder)) != 0) return 0;
    if (faults[0]) __sync_fetch_and_add(&faults[3], 1);
    while (faults[0]) usleep(2000);
    errno = (int)faults[1];
    return errno != 0;
}

ssize_t write(int descriptor, const void *data, size_t size) {
    return fails(descriptor) ? -1 : syscall(SYS_write, descriptor, data, size);
}

int fsync(int descriptor) { return fails(descriptor) ? -1 : (int)syscall(SYS_fsync, descriptor); }

int clock_gettime(clockid_t clock, struct timespec *now) {
    static int (*real)(clockid_t, struct timespec *);
    if (!real) real = dlsym(RTLD_NEXT, "clock_gettime");
    int result = real(clock, now);
    if (faults && result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
        now->tv_sec += faults[2];
    return result;
}

int gettimeofday(struct timeval *now, void *zone) {
    struct timespec exact;
    (void)zone;
    if (clock_gettime(CLOCK_REALTIME, &exact)) return -1;
    now->tv_sec = exact.tv_sec;
    now->tv_usec = exact.tv_nsec / 1000;
    return 0;
}

time_t time(time_t *kept) {
    struct timespec exact;
    clock_gettime(CLOCK_REALTIME, &exact);
    if (kept) *kept = exact.tv_sec;
    return exact.tv_sec;
}
