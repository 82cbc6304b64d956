/* Load on the service: clients that send recorded events, and the delay of every answer.

   generator PLAN prints a JSON object. In an open loop each client keeps to its schedule whatever comes back,
   and the delay counts from the time at which a frame was to be sent, so that frames which wait for others are
   counted as well. In turns each client has one frame under way, and the servers' processor time is counted. */
#define _GNU_SOURCE
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>
#include <dirent.h>

#include "plan.h"

static struct plan *plan;
static struct client *clients;
static int client_count, waiting;
static int64_t start_ns, warm_ns, end_ns;
static bool in_turns, turn_over;

static int64_t now_ns(clockid_t clock) {
    struct timespec time;
    clock_gettime(clock, &time);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

/* Processor time of all threads of a process so far. */
static int64_t process_ns(pid_t pid) {
    char path[300];
    int64_t sum = 0, one;
    snprintf(path, sizeof path, "/proc/%d/task", pid);
    DIR *threads = opendir(path);
    if (!threads) return 0;
    for (struct dirent *entry; (entry = readdir(threads));) {
        if (entry->d_name[0] == '.') continue;
        snprintf(path, sizeof path, "/proc/%d/task/%.20s/schedstat", pid, entry->d_name);
        FILE *file = fopen(path, "r");
        if (file && fscanf(file, "%ld", &one) == 1) sum += one;
        if (file) fclose(file);
    }
    closedir(threads);
    return sum;
}

static int64_t servers_ns(struct group *group) {
    int64_t sum = 0;
    for (int i = 0; i < group->pid_count; i++) sum += process_ns(group->pids[i]);
    return sum;
}

static int64_t due_ns(const struct client *client, long frame) {
    return start_ns + client->offset_ns + frame * client->group->gap_ns;
}

static void record(struct client *client, long frame, int64_t now) {
    struct group *group = client->group;
    int64_t due = due_ns(client, frame), delay = now - due;
    if (due < warm_ns || due >= end_ns) return;
    histogram_add(&group->delay, delay);
    size_t window = (size_t)((double)(due - warm_ns) * 1e-9 / plan->window);
    if (window >= MOST_WINDOWS) return;
    if (!group->windows[window]) group->windows[window] = calloc(1, sizeof *group->windows[window]);
    histogram_add(group->windows[window], delay);
}

/* An answer covers every frame up to the one that it names. */
static void on_answer(struct client *client, long frame) {
    struct group *group = client->group;
    if (frame >= client->sent) fail("%s: an answer to frame %ld of %ld", group->name, frame, client->sent);
    group->answers++;
    if (frame < client->answered) group->repeated++;
    int64_t now = in_turns ? 0 : now_ns(CLOCK_MONOTONIC);
    for (; client->answered <= frame; client->answered++, group->answered++)
        if (!in_turns) record(client, client->answered, now);
    if (in_turns && !turn_over && client->answered == client->sent) client_send(client);
}

/* A binary heap of clients by the time of their next frame. */
static struct client **heap;
static int heap_size;

static bool earlier(int a, int b) { return due_ns(heap[a], heap[a]->due) < due_ns(heap[b], heap[b]->due); }

static void swap(int a, int b) {
    struct client *other = heap[a];
    heap[a] = heap[b], heap[b] = other;
}

static void sift_down(int at) {
    for (int child; (child = 2 * at + 1) < heap_size; at = child) {
        if (child + 1 < heap_size && earlier(child + 1, child)) child++;
        if (!earlier(child, at)) return;
        swap(child, at);
    }
}

static void watch(struct client *client, int operation) {
    struct epoll_event event = {.events = EPOLLIN | (client->blocked ? EPOLLOUT : 0), .data.ptr = client};
    if (client->closed) operation = EPOLL_CTL_DEL;
    epoll_ctl(waiting, operation, client->fd, &event);
}

/* Send every frame that is due; a client whose socket is full goes on when it has room. */
static void send_due(struct client *client) {
    while (!client->blocked && !client->closed && client->sent < client->due) {
        int64_t now = now_ns(CLOCK_MONOTONIC), due = due_ns(client, client->sent);
        if (client->sent == client->due - 1 && due >= warm_ns && due < end_ns)
            histogram_add(&client->group->late, now - due);
        client_send(client);
        if (client->blocked) watch(client, EPOLL_CTL_MOD);
    }
}

/* Wait for sockets until a time, at most 50 ms: as long as it needs to notice the end. */
static void wait_and_read(int64_t until) {
    struct epoll_event events[64];
    int64_t pause = until - now_ns(CLOCK_MONOTONIC);
    if (pause < 0) pause = 0;
    if (pause > 50000000) pause = 50000000;
    struct timespec timeout = {0, pause};
    int count = epoll_pwait2(waiting, events, 64, &timeout, NULL);
    if (count < 0 && errno != EINTR) fail("epoll_pwait2: %s", strerror(errno));
    for (int i = 0; i < count; i++) {
        struct client *client = events[i].data.ptr;
        if (events[i].events & EPOLLOUT && client_flush(client)) {
            watch(client, EPOLL_CTL_MOD);
            send_due(client);
        }
        if (events[i].events & ~EPOLLOUT) {
            bool blocked = client->blocked;
            client_read(client, on_answer);
            if (client->closed || client->blocked != blocked) watch(client, EPOLL_CTL_MOD);
        }
    }
}

static bool all_answered(void) {
    for (int i = 0; i < client_count; i++) {
        struct client *client = clients + i;
        if (client->group->kind != SCRIPT && !client->closed && client->answered < client->due) return false;
    }
    return true;
}

static void measure_servers(int sign) {
    for (int i = 0; i < plan->group_count; i++) {
        struct group *group = plan->groups + i;
        for (int p = 0; p < group->pid_count; p++) group->pid_ns[p] += sign * process_ns(group->pids[p]);
        group->measured = group->answered - (sign > 0 ? group->measured : 0);
    }
}

/* Returns the generator's own share of a processor. */
static double open_loop(void) {
    heap = calloc((size_t)client_count, sizeof *heap);
    for (heap_size = 0; heap_size < client_count; heap_size++) heap[heap_size] = clients + heap_size;
    start_ns = now_ns(CLOCK_MONOTONIC) + 20000000;
    warm_ns = start_ns + (int64_t)(plan->warm * 1e9);
    end_ns = warm_ns + (int64_t)(plan->seconds * 1e9);
    for (int at = client_count / 2; at >= 0; at--) sift_down(at);
    int64_t own = 0;
    bool measuring = false;
    for (;;) {
        int64_t now = now_ns(CLOCK_MONOTONIC);
        if (!measuring && now >= warm_ns) {
            measure_servers(-1);
            own = now_ns(CLOCK_PROCESS_CPUTIME_ID);
            measuring = true;
        }
        while (due_ns(heap[0], heap[0]->due) <= now && due_ns(heap[0], heap[0]->due) < end_ns) {
            heap[0]->due++;
            send_due(heap[0]);
            sift_down(0);
        }
        int64_t next = due_ns(heap[0], heap[0]->due);
        if (now >= end_ns) break;
        wait_and_read(next < end_ns ? next : end_ns);
    }
    measure_servers(1);
    double share = (double)(now_ns(CLOCK_PROCESS_CPUTIME_ID) - own) / (double)(now_ns(CLOCK_MONOTONIC) - warm_ns);
    int64_t drained = end_ns + (int64_t)(plan->drain * 1e9);
    while (!all_answered() && now_ns(CLOCK_MONOTONIC) < drained) wait_and_read(drained);
    return share;
}

/* One turn of a group: the servers' processor time for each answer, us. */
static double turn(struct group *group) {
    long before = group->answered;
    int64_t servers = servers_ns(group);
    int64_t until = now_ns(CLOCK_MONOTONIC) + (int64_t)(plan->turn * 1e9);
    turn_over = false;
    for (int i = 0; i < group->clients; i++) client_send(group->first + i);
    while (now_ns(CLOCK_MONOTONIC) < until) wait_and_read(until);
    turn_over = true;
    for (int i = 0; i < group->clients; i++) {
        while (group->first[i].answered < group->first[i].sent) {
            if (group->first[i].closed) fail("%s: the service closed a connection", group->name);
            wait_and_read(now_ns(CLOCK_MONOTONIC) + 50000000);
        }
    }
    return (double)(servers_ns(group) - servers) * 1e-3 / (double)(group->answered - before);
}

static double turns(void) {
    int64_t own = now_ns(CLOCK_PROCESS_CPUTIME_ID), before = now_ns(CLOCK_MONOTONIC);
    in_turns = true;
    for (int round = 0; round < plan->rounds; round++)
        for (int i = 0; i < plan->group_count; i++) plan->groups[i].turns_us[round] = turn(plan->groups + i);
    return (double)(now_ns(CLOCK_PROCESS_CPUTIME_ID) - own) / (double)(now_ns(CLOCK_MONOTONIC) - before);
}

static void open_clients(void) {
    for (int i = 0; i < plan->group_count; i++) client_count += plan->groups[i].clients;
    clients = calloc((size_t)client_count, sizeof *clients);
    waiting = epoll_create1(0);
    struct client *client = clients;
    for (int i = 0; i < plan->group_count; i++) {
        struct group *group = plan->groups + i;
        group->first = client;
        if (plan->rounds) group->turns_us = calloc((size_t)plan->rounds, sizeof *group->turns_us);
        for (int k = 0; k < group->clients; k++, client++) {
            client->group = group;
            client->offset_ns = group->gap_ns * ((int64_t)k * plan->group_count + i) / ((int64_t)group->clients * plan->group_count);
            if (group->size) {
                size_t frames = group->event_count / (size_t)group->size;
                client->place = frames * (size_t)k / (size_t)group->clients * (size_t)group->size;
            }
            client_open(client);
            watch(client, EPOLL_CTL_ADD);
        }
    }
}

static void print_tallies(const char *name, const struct tally *tallies) {
    printf(", \"%s\": {", name);
    for (int i = 0; i < MOST_NAMES && tallies[i].count; i++)
        printf("%s\"%s\": %ld", i ? ", " : "", tallies[i].name, tallies[i].count);
    printf("}");
}

static void print_delays(const char *name, const struct histogram *delays) {
    printf(", \"%s\": {\"count\": %ld", name, (long)delays->count);
    static const struct { const char *name; double share; } quantiles[] = {
        {"p50", 0.5}, {"p90", 0.9}, {"p99", 0.99}, {"p999", 0.999}};
    for (int i = 0; i < 4; i++)
        printf(", \"%s_ms\": %.4f", quantiles[i].name, (double)histogram_quantile(delays, quantiles[i].share) * 1e-6);
    printf(", \"max_ms\": %.4f}", (double)delays->largest * 1e-6);
}

static void print_windows(struct group *group) {
    printf(", \"windows\": [");
    for (int i = 0; i < MOST_WINDOWS && group->windows[i]; i++) {
        struct histogram *window = group->windows[i];
        printf("%s{\"p50_ms\": %.4f, \"p99_ms\": %.4f}", i ? ", " : "",
               (double)histogram_quantile(window, 0.5) * 1e-6, (double)histogram_quantile(window, 0.99) * 1e-6);
    }
    printf("]");
}

static void print_group(struct group *group) {
    long unanswered = 0;
    printf("{\"name\": \"%s\"", group->name);
    for (int i = 0; i < group->clients; i++)
        unanswered += group->kind == SCRIPT ? 0 : (in_turns ? group->first[i].sent : group->first[i].due) - group->first[i].answered;
    printf(", \"sent\": %ld, \"answered\": %ld, \"answers\": %ld, \"repeated\": %ld, \"unanswered\": %ld",
           group->sent, group->answered, group->answers, group->repeated, unanswered);
    printf(", \"measured\": %ld", group->measured);
    print_tallies("texts", group->texts);
    print_tallies("closes", group->closes);
    printf(", \"server_s\": [");
    for (int i = 0; i < group->pid_count; i++) printf("%s%.6f", i ? ", " : "", (double)group->pid_ns[i] * 1e-9);
    printf("]");
    print_delays("delay", &group->delay);
    print_delays("late", &group->late);
    print_windows(group);
    printf(", \"turns_us\": [");
    for (int i = 0; group->turns_us && i < plan->rounds; i++) printf("%s%.4f", i ? ", " : "", group->turns_us[i]);
    printf("]}");
}

/* What was never answered has waited at least until now. */
static void record_unanswered(void) {
    int64_t now = now_ns(CLOCK_MONOTONIC);
    for (int i = 0; i < client_count; i++)
        if (clients[i].group->kind != SCRIPT)
            for (long frame = clients[i].answered; frame < clients[i].due; frame++) record(clients + i, frame, now);
}

int main(int count, char **words) {
    if (count != 2) fail("usage: generator PLAN");
    plan = plan_read(words[1]);
    prctl(PR_SET_TIMERSLACK, 1);
    open_clients();
    double share = plan->turn > 0 ? turns() : open_loop();
    if (!in_turns) record_unanswered();
    printf("{\"own_share\": %.4f, \"groups\": [", share);
    for (int i = 0; i < plan->group_count; i++) {
        if (i) printf(", ");
        print_group(plan->groups + i);
    }
    printf("]}\n");
    return 0;
}
