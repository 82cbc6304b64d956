/* A histogram of nanoseconds with buckets of under 1 %: 128 for each power of two, up to 18 minutes. */
#ifndef HISTOGRAM_H
#define HISTOGRAM_H

#include <stdint.h>

enum { PRECISION_BITS = 7, POWERS = 34, BUCKETS = (POWERS + 1) << PRECISION_BITS };

struct histogram {
    uint64_t count;
    int64_t largest;
    uint32_t buckets[BUCKETS];
};

static inline int bucket_of(uint64_t value) {
    if (value < (1u << PRECISION_BITS)) return (int)value;
    int shift = 63 - __builtin_clzll(value) - PRECISION_BITS;
    int bucket = (shift << PRECISION_BITS) + (int)(value >> shift);
    return bucket < BUCKETS ? bucket : BUCKETS - 1;
}

static inline void histogram_add(struct histogram *histogram, int64_t value) {
    if (value < 0) value = 0;
    histogram->count++;
    if (value > histogram->largest) histogram->largest = value;
    histogram->buckets[bucket_of((uint64_t)value)]++;
}

/* The largest value of the bucket in which this share of all values is reached. */
static inline int64_t histogram_quantile(const struct histogram *histogram, double share) {
    uint64_t wanted = (uint64_t)(share * (double)histogram->count + 0.999999), seen = 0;
    for (int bucket = 0; bucket < BUCKETS; bucket++) {
        seen += histogram->buckets[bucket];
        if (seen && seen >= wanted) {
            int shift = (bucket >> PRECISION_BITS) - 1;
            if (shift < 0) return bucket;
            int64_t top = ((int64_t)(bucket - (shift << PRECISION_BITS)) + 1) << shift;
            return top < histogram->largest ? top : histogram->largest;
        }
    }
    return 0;
}

#endif
