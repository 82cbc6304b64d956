#define _GNU_SOURCE
#include "client.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <netinet/tcp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

enum { CONTINUATION = 0, TEXT = 1, BINARY = 2, CLOSE = 8, PING = 9, PONG = 10 };
enum { EVENT_BYTES = 30, PREDICTION_BYTES = 65, LONGEST_HEADER = 14 };

static const char RESET[] = "{\"type\":\"reset\"}";
static const char PREDICTION[] = "{\"type\":\"prediction\",\"t\":";
static const char EVENTS[] = "{\"type\":\"events\",\"events\":[[";

void fail(const char *format, ...) {
    va_list values;
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    exit(1);
}

static void *grown(void *memory, size_t *room, size_t needed) {
    if (needed <= *room) return memory;
    *room = needed * 2;
    memory = realloc(memory, *room);
    if (!memory) fail("no memory for %zu bytes", *room);
    return memory;
}

static uint32_t random_key(void) {
    static uint32_t state = 0x9e3779b9u;
    state ^= state << 13, state ^= state >> 17, state ^= state << 5;
    return state;
}

static void mask(char *data, size_t size, uint32_t key) {
    uint64_t wide = (uint64_t)key << 32 | key, part;
    size_t at = 0;
    for (; at + 8 <= size; at += 8) {
        memcpy(&part, data + at, 8);
        part ^= wide;
        memcpy(data + at, &part, 8);
    }
    for (; at < size; at++) data[at] ^= (char)(key >> 8 * (at & 3));
}

/* Append a frame as a client sends it; its payload is masked with a key of its own. */
static void append_frame(struct client *client, uint8_t opcode, const char *payload, size_t size) {
    client->out = grown(client->out, &client->out_room, client->out_size + size + LONGEST_HEADER);
    uint8_t *head = (uint8_t *)client->out + client->out_size;
    size_t used = 2;
    head[0] = 0x80 | opcode;
    if (size < 126) {
        head[1] = (uint8_t)(0x80 | size);
    } else if (size < 65536) {
        head[1] = 0x80 | 126, head[2] = (uint8_t)(size >> 8), head[3] = (uint8_t)size, used = 4;
    } else {
        head[1] = 0x80 | 127, used = 10;
        for (int i = 0; i < 8; i++) head[2 + i] = (uint8_t)((uint64_t)size >> 8 * (7 - i));
    }
    uint32_t key = random_key();
    memcpy(head + used, &key, 4);
    memcpy(head + used + 4, payload, size);
    mask((char *)head + used + 4, size, key);
    client->out_size += used + 4 + size;
}

bool client_flush(struct client *client) {
    size_t written = 0;
    while (written < client->out_size && !client->closed) {
        ssize_t count = send(client->fd, client->out + written, client->out_size - written, MSG_NOSIGNAL);
        if (count >= 0) written += (size_t)count;
        else if (errno == EAGAIN) break;
        else if (errno == EPIPE || errno == ECONNRESET) written = client->out_size; /* read tells why */
        else if (errno != EINTR) fail("send: %s", strerror(errno));
    }
    if (written) memmove(client->out, client->out + written, client->out_size - written);
    client->out_size -= written;
    client->blocked = client->out_size > 0;
    return !client->blocked;
}

static size_t put_seconds(char *at, int64_t t_ns) {
    return (size_t)sprintf(at, "%lld.%09lld", (long long)(t_ns / 1000000000), (long long)(t_ns % 1000000000));
}

static void append_events(struct client *client) {
    static char payload[1 << 18];
    struct group *group = client->group;
    size_t used = 0;
    if (client->place >= group->event_count) client->place = 0;
    const struct event *events = group->events + client->place;
    if (events->begin && client->sent && group->kind == STREAM)
        append_frame(client, TEXT, RESET, sizeof RESET - 1);
    if (group->json) used = (size_t)sprintf(payload, "{\"type\":\"events\",\"events\":[");
    for (int i = 0; i < group->size; i++) {
        int64_t t_ns = (client->sent * group->size + i + 1) * group->period_ns;
        if (group->json) {
            payload[used++] = '[';
            used += put_seconds(payload + used, t_ns);
            memcpy(payload + used, events[i].text, events[i].text_size);
            used += events[i].text_size;
            if (i + 1 < group->size) payload[used++] = ',';
        } else {
            double t = (double)t_ns * 1e-9;
            memcpy(payload + used, &t, 8);
            memcpy(payload + used + 8, events[i].packed, 22);
            used += EVENT_BYTES;
        }
    }
    if (group->json) payload[used++] = ']', payload[used++] = '}';
    client->place += (size_t)group->size;
    append_frame(client, group->json ? TEXT : BINARY, payload, used);
}

void client_send(struct client *client) {
    struct group *group = client->group;
    if (group->kind == SCRIPT) {
        const struct message *message = group->messages + client->sent % group->message_count;
        append_frame(client, message->opcode, message->payload, message->size);
    } else {
        append_events(client);
    }
    client->sent++;
    group->sent++;
    client_flush(client);
}

static void count_name(struct tally *tallies, const char *name, size_t size) {
    if (size >= NAME_CHARS) size = NAME_CHARS - 1;
    for (int i = 0; i < MOST_NAMES; i++) {
        if (!tallies[i].count) memcpy(tallies[i].name, name, size);
        if (strncmp(tallies[i].name, name, size) || tallies[i].name[size]) continue;
        tallies[i].count++;
        return;
    }
    fail("more than %d kinds of answers", MOST_NAMES);
}

/* Count a text that is no prediction: an error by its code, another message by its type. */
static void count_text(struct group *group, const char *text, size_t size) {
    static const char code[] = "\"code\":\"", type[] = "\"type\":\"";
    const char *at = memmem(text, size, code, sizeof code - 1);
    if (!at) at = memmem(text, size, type, sizeof type - 1);
    const char *name = at ? at + sizeof code - 1 : "other";
    const char *end = at ? memchr(name, '"', (size_t)(text + size - name)) : name + 5;
    count_name(group->texts, name, end ? (size_t)(end - name) : 0);
}

/* The newest frame that an answer answers; -1 for what answers no frame. */
static long frame_answered(struct group *group, uint8_t opcode, const char *payload, size_t size) {
    double t;
    if (group->kind == SCRIPT) {
        if (opcode == TEXT) count_text(group, payload, size);
        return -1;
    }
    if (opcode == BINARY) {
        size_t record = group->kind == STREAM ? PREDICTION_BYTES : EVENT_BYTES;
        if (size < record || size % record) fail("%s: an answer of %zu bytes", group->name, size);
        memcpy(&t, payload + size - record, 8);
    } else {
        const char *head = group->kind == STREAM ? PREDICTION : EVENTS;
        size_t length = group->kind == STREAM ? sizeof PREDICTION - 1 : sizeof EVENTS - 1;
        if (size <= length || memcmp(payload, head, length)) {
            count_text(group, payload, size);
            return -1;
        }
        t = strtod(payload + length, NULL); /* the first event of an echo: a frame has one number */
    }
    return (llround(t * 1e9 / (double)group->period_ns) - 1) / group->size;
}

static void receive(struct client *client, uint8_t opcode, const char *payload, size_t size,
                    void (*answered)(struct client *, long)) {
    if (opcode == PING) {
        append_frame(client, PONG, payload, size);
        client_flush(client);
    } else if (opcode == CLOSE) {
        char code[8] = "1005";
        if (size >= 2) snprintf(code, sizeof code, "%d", (uint8_t)payload[0] << 8 | (uint8_t)payload[1]);
        count_name(client->group->closes, code, strlen(code));
        client->closed = true;
    } else if (opcode != PONG) {
        if (opcode == CONTINUATION) fail("%s: an answer in fragments", client->group->name);
        long frame = frame_answered(client->group, opcode, payload, size);
        if (frame >= 0) answered(client, frame);
    }
}

/* The payload of the frame at the start of what has come, unmasked; its whole size, 0 while it is not whole. */
static size_t parse(char *data, size_t size, char **payload, size_t *length) {
    const uint8_t *head = (const uint8_t *)data;
    size_t used = 2;
    if (size < 2) return 0;
    *length = head[1] & 127;
    if (*length == 126) {
        if (size < 4) return 0;
        *length = (size_t)head[2] << 8 | head[3], used = 4;
    } else if (*length == 127) {
        if (size < 10) return 0;
        *length = 0, used = 10;
        for (int i = 2; i < 10; i++) *length = *length << 8 | head[i];
    }
    bool masked = head[1] & 0x80;
    if (masked) used += 4;
    if (size < used + *length) return 0;
    *payload = data + used;
    if (masked) {
        uint32_t key;
        memcpy(&key, data + used - 4, 4);
        mask(*payload, *length, key);
    }
    return used + *length;
}

void client_read(struct client *client, void (*answered)(struct client *, long)) {
    enum { PIECE = 1 << 16 };
    client->in = grown(client->in, &client->in_room, client->in_size + PIECE + 1);
    ssize_t count = recv(client->fd, client->in + client->in_size, PIECE, 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) {
        if (!client->closed) count_name(client->group->closes, "1006", 4);
        client->closed = true;
        return;
    }
    client->in_size += (size_t)count;
    size_t at = 0, whole, length;
    char *payload;
    while ((whole = parse(client->in + at, client->in_size - at, &payload, &length))) {
        char after = payload[length];
        payload[length] = 0; /* a number at its end stops there */
        receive(client, client->in[at] & 15, payload, length, answered);
        payload[length] = after;
        at += whole;
    }
    memmove(client->in, client->in + at, client->in_size - at);
    client->in_size -= at;
}

static void wait_for(struct client *client, const char *wanted) {
    client->in = grown(client->in, &client->in_room, 1 << 16);
    while (client->in_size < client->in_room - 1) {
        ssize_t count = recv(client->fd, client->in + client->in_size, client->in_room - 1 - client->in_size, 0);
        if (count <= 0) fail("%s: the service closed the connection before %s", client->group->name, wanted);
        client->in_size += (size_t)count;
        char *at = memmem(client->in, client->in_size, wanted, strlen(wanted));
        if (!at) continue;
        return;
    }
    fail("%s: no %s", client->group->name, wanted);
}

static void upgrade(struct client *client) {
    struct group *group = client->group;
    char request[1024];
    int size = snprintf(request, sizeof request,
                        "GET %s HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nUpgrade: websocket\r\n"
                        "Connection: Upgrade\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
                        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: pointpred.v1\r\n\r\n",
                        group->path, group->port);
    if (send(client->fd, request, (size_t)size, 0) != size) fail("send: %s", strerror(errno));
    wait_for(client, "\r\n\r\n");
    if (memcmp(client->in, "HTTP/1.1 101", 12)) fail("%s: no upgrade: %.*s", group->name, 60, client->in);
    client->in_size = 0;
}

void client_open(struct client *client) {
    struct group *group = client->group;
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)group->port)};
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int on = 1;
    client->fd = socket(AF_INET, SOCK_STREAM, 0);
    if (client->fd < 0 || connect(client->fd, (struct sockaddr *)&address, sizeof address))
        fail("%s: connect to port %d: %s", group->name, group->port, strerror(errno));
    setsockopt(client->fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (group->kind != RAW) upgrade(client);
    for (int i = 0; i < group->greeting_count; i++) {
        append_frame(client, group->greeting[i].opcode, group->greeting[i].payload, group->greeting[i].size);
        if (!client_flush(client)) fail("%s: the greeting was not read", group->name);
        if (i == 0) wait_for(client, "\"welcome\"");
    }
    client->in_size = 0; /* a welcome is short and comes whole */
    fcntl(client->fd, F_SETFL, O_NONBLOCK);
}
