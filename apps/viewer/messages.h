// SPDX-License-Identifier: MIT
// Messages of the library while the window is open: printed on stderr, and the last lines kept for the panel.
#ifndef VIEWER_MESSAGES_H
#define VIEWER_MESSAGES_H

#ifdef __cplusplus
extern "C" {
#endif

#define MESSAGES_KEPT 6
#define MESSAGE_MAX 1024

void messages_start(void); // takes the log hook
void messages_stop(void);  // gives it back
void messages_clear(void);
// The latest is number 0; NULL past the oldest.
const char *messages_get(unsigned back);
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
void messages_add(const char *format, ...);

#ifdef __cplusplus
}
#endif
#endif
