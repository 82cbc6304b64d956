/* One client: a WebSocket to the service, the frames that it sends, and the answers that it gets. */
#ifndef CLIENT_H
#define CLIENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include "histogram.h"

enum { MOST_PIDS = 32, MOST_NAMES = 24, NAME_CHARS = 32, MOST_WINDOWS = 4096 };

/* stream: sessions of the service; echo: a WebSocket that sends each frame back; raw: the same bytes over
   plain TCP; script: given messages at a given rate, whose answers are counted and not timed. */
enum kind { STREAM, ECHO, RAW, SCRIPT };

/* Recorded events without their times: begin, x, y, counts and buttons packed, and the same as JSON. */
struct event {
    uint8_t begin, text_size;
    char packed[22];
    char text[102];
};

struct message {
    uint8_t opcode;
    uint32_t size;
    const char *payload;
};

struct tally {
    char name[NAME_CHARS];
    long count;
};

struct group {
    char name[64], path[256];
    enum kind kind;
    int port, clients, size, pid_count, message_count, connected;
    pid_t pids[MOST_PIDS];
    bool json;
    double rate;
    int64_t gap_ns, period_ns; /* between frames, and between events, of one client */
    const struct event *events;
    size_t event_count;
    const struct message *greeting, *messages; /* the first messages of a session; those of a script */
    int greeting_count;
    struct client *first; /* the group's clients, one after another */
    long sent, answered, answers, repeated, measured;
    struct tally texts[MOST_NAMES], closes[MOST_NAMES]; /* other texts by code or type; closes by code */
    struct histogram delay, late;
    struct histogram *windows[MOST_WINDOWS];
    int64_t pid_ns[MOST_PIDS];
    double *turns_us;
};

struct client {
    struct group *group;
    int fd;
    int64_t offset_ns; /* of its schedule against the others' */
    long sent, answered, due;
    size_t place; /* of the next event in the recorded ones */
    bool blocked, closed;
    char *out, *in;
    size_t out_size, out_room, in_size, in_room;
};

void fail(const char *format, ...) __attribute__((noreturn, format(printf, 1, 2)));

/* Connect and greet; returns when the service has answered the first message. */
void client_open(struct client *client);

/* Compose the next frame, or message of a script, and write what the socket takes. */
void client_send(struct client *client);

/* Write what waits; false while the socket does not take it all. */
bool client_flush(struct client *client);

/* Read what has come and hand each answer to `answered`: the number of the newest frame that it answers. */
void client_read(struct client *client, void (*answered)(struct client *client, long frame));

#endif
