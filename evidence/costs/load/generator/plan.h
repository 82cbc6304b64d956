/* What a run is to do: words of the form name=value, read from a file. */
#ifndef PLAN_H
#define PLAN_H

#include "client.h"

enum { MOST_GROUPS = 32 };

struct plan {
    double seconds, warm, drain, window; /* s; the length of a window in which the delay is reported */
    double turn;                         /* s; above 0: each client has one frame under way, in turns */
    int rounds;                          /* of turns */
    int group_count;
    struct group *groups;
};

struct plan *plan_read(const char *path);

#endif
