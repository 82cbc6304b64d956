#define _GNU_SOURCE
#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *whole_file(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    if (!file) fail("cannot read %s", path);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *data = malloc(*size + 1);
    if (!data || fread(data, 1, *size, file) != *size) fail("cannot read %s", path);
    fclose(file);
    data[*size] = 0;
    return data;
}

/* Messages one after another: a byte of opcode, four bytes of size, the payload. */
static const struct message *read_messages(const char *path, int *count) {
    size_t size, at = 0, room = 0;
    char *data = whole_file(path, &size);
    struct message *messages = NULL;
    for (*count = 0; at + 5 <= size; (*count)++) {
        if ((size_t)*count >= room) messages = realloc(messages, (room = 2 * room + 16) * sizeof *messages);
        struct message *message = messages + *count;
        message->opcode = (uint8_t)data[at];
        memcpy(&message->size, data + at + 1, 4);
        message->payload = data + at + 5;
        at += 5 + message->size;
    }
    if (at != size) fail("%s ends within a message", path);
    return messages;
}

static void read_numbers(struct group *group, char *list) {
    for (char *rest, *word = strtok_r(list, ",", &rest); word; word = strtok_r(NULL, ",", &rest)) {
        if (group->pid_count == MOST_PIDS) fail("more than %d processes", MOST_PIDS);
        group->pids[group->pid_count++] = atoi(word);
    }
}

static enum kind kind_of(const char *name) {
    static const char *names[] = {"stream", "echo", "raw", "script"};
    for (int i = 0; i < 4; i++)
        if (!strcmp(name, names[i])) return (enum kind)i;
    fail("unknown kind %s", name);
}

static void set_group(struct group *group, const char *name, char *value) {
    size_t size;
    if (!strcmp(name, "kind")) group->kind = kind_of(value);
    else if (!strcmp(name, "port")) group->port = atoi(value);
    else if (!strcmp(name, "pids")) read_numbers(group, value);
    else if (!strcmp(name, "path")) snprintf(group->path, sizeof group->path, "%s", value);
    else if (!strcmp(name, "clients")) group->clients = atoi(value);
    else if (!strcmp(name, "rate")) group->rate = atof(value);
    else if (!strcmp(name, "size")) group->size = atoi(value);
    else if (!strcmp(name, "json")) group->json = atoi(value);
    else if (!strcmp(name, "greeting")) group->greeting = read_messages(value, &group->greeting_count);
    else if (!strcmp(name, "messages")) group->messages = read_messages(value, &group->message_count);
    else if (!strcmp(name, "events")) {
        group->events = (const struct event *)whole_file(value, &size);
        group->event_count = size / sizeof(struct event);
    } else fail("unknown word %s of a group", name);
}

static void set_plan(struct plan *plan, const char *name, const char *value) {
    if (!strcmp(name, "seconds")) plan->seconds = atof(value);
    else if (!strcmp(name, "warm")) plan->warm = atof(value);
    else if (!strcmp(name, "drain")) plan->drain = atof(value);
    else if (!strcmp(name, "window")) plan->window = atof(value);
    else if (!strcmp(name, "turn")) plan->turn = atof(value);
    else if (!strcmp(name, "rounds")) plan->rounds = atoi(value);
    else fail("unknown word %s of a plan", name);
}

static void check(struct group *group) {
    bool script = group->kind == SCRIPT;
    if (group->clients < 1 || group->rate <= 0 || (script ? !group->message_count : group->size < 1))
        fail("%s needs clients, a rate, and events or messages", group->name);
    group->gap_ns = llround(1e9 / group->rate);
    if (script) return;
    group->period_ns = group->gap_ns / group->size;
    if (group->period_ns * group->size != group->gap_ns)
        fail("%s: %g frames a second of %d events are no whole number of ns", group->name, group->rate, group->size);
    if (group->event_count < (size_t)group->size || group->event_count % (size_t)group->size)
        fail("%s: the events are no whole number of frames", group->name);
}

struct plan *plan_read(const char *path) {
    size_t size;
    struct plan *plan = calloc(1, sizeof *plan);
    char *rest, *data = whole_file(path, &size);
    plan->groups = calloc(MOST_GROUPS, sizeof *plan->groups);
    for (char *word = strtok_r(data, "\n", &rest); word; word = strtok_r(NULL, "\n", &rest)) {
        char *value = strchr(word, '=');
        if (!value) fail("%s is not name=value", word);
        *value++ = 0;
        if (!strcmp(word, "group")) {
            if (plan->group_count == MOST_GROUPS) fail("more than %d groups", MOST_GROUPS);
            struct group *group = plan->groups + plan->group_count++;
            snprintf(group->name, sizeof group->name, "%s", value);
        } else if (plan->group_count) {
            set_group(plan->groups + plan->group_count - 1, word, value);
        } else {
            set_plan(plan, word, value);
        }
    }
    for (int i = 0; i < plan->group_count; i++) check(plan->groups + i);
    return plan;
}
