// meshes/seal.c
#include "meshes/seal.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MOST_OPEN_FILES = 64 };

// never above what holds already
static bool limit(int what, rlim_t most)
{
    struct rlimit now;
    if (getrlimit((__rlimit_resource_t)what, &now) != 0) {
        return false;
    }
    const rlim_t least = now.rlim_max < most ? now.rlim_max : most;
    const struct rlimit both = {.rlim_cur = least, .rlim_max = least};
    return setrlimit((__rlimit_resource_t)what, &both) == 0;
}

// address space in use
static size_t used_memory(void)
{
    unsigned long pages = 0;
    FILE *f = fopen("/proc/self/statm", "r");
    if (f) {
        if (fscanf(f, "%lu", &pages) != 1) {
            pages = 0;
        }
        (void)fclose(f);
    }
    return (size_t)pages * (size_t)sysconf(_SC_PAGESIZE);
}

// --- a filter of system calls: those that leave a trace fail with EPERM

#if defined __x86_64__
#define OUR_ARCHITECTURE AUDIT_ARCH_X86_64
#elif defined __aarch64__
#define OUR_ARCHITECTURE AUDIT_ARCH_AARCH64
#endif

#ifdef OUR_ARCHITECTURE

static const int refused[] = {
    SYS_execve,         SYS_execveat,
    SYS_socket,         SYS_connect,
    SYS_bind,           SYS_unlinkat,
    SYS_renameat2,      SYS_mkdirat,
    SYS_mknodat,        SYS_linkat,
    SYS_symlinkat,      SYS_fchmod,
    SYS_fchmodat,       SYS_fchown,
    SYS_fchownat,       SYS_truncate,
    SYS_ftruncate,      SYS_fallocate,
    SYS_utimensat,      SYS_setxattr,
    SYS_fsetxattr,      SYS_lsetxattr,
    SYS_kill,           SYS_tkill,
    SYS_ptrace,         SYS_process_vm_writev,
    SYS_mount,          SYS_umount2,
    SYS_chroot,         SYS_prlimit64,
#ifdef SYS_open // the older names of some of them
    SYS_fork,           SYS_vfork,
    SYS_creat,          SYS_unlink,
    SYS_rename,         SYS_renameat,
    SYS_mkdir,          SYS_rmdir,
    SYS_mknod,          SYS_link,
    SYS_symlink,        SYS_chmod,
    SYS_chown,          SYS_lchown,
    SYS_utime,          SYS_utimes,
    SYS_setrlimit,
#endif
#ifdef SYS_openat2
    SYS_openat2,
#endif
#ifdef SYS_io_uring_setup
    SYS_io_uring_setup,
#endif
};

enum {
    REFUSE = SECCOMP_RET_ERRNO | EPERM,
    ABSENT = SECCOMP_RET_ERRNO | ENOSYS,
    MOST_STEPS = 160,
};

typedef struct filter {
    struct sock_filter step[MOST_STEPS];
    unsigned short count;
} filter;

static void add(filter *f, unsigned code, uint32_t k, int yes, int no)
{
    f->step[f->count++] =
        (struct sock_filter){.code = (uint16_t)code, .k = k, .jt = (uint8_t)yes, .jf = (uint8_t)no};
}

static void load(filter *f, size_t offset)
{
    add(f, BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset, 0, 0);
}

static void answer(filter *f, uint32_t what)
{
    add(f, BPF_RET | BPF_K, what, 0, 0);
}

// this call's argument has one of the bits (or none of them, where `absent`): refused
static void refuse_bits(filter *f, int call, int argument, uint32_t bits, bool absent)
{
    // the low half of the argument: we are little-endian on both architectures
    add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)call, 0, 4);
    load(f, offsetof(struct seccomp_data, args) + 8 * (size_t)argument);
    add(f, BPF_JMP | BPF_JSET | BPF_K, bits, absent ? 1 : 0, absent ? 0 : 1);
    answer(f, REFUSE);
    answer(f, SECCOMP_RET_ALLOW);
}

static bool install_filter(void)
{
    filter f = {.count = 0};
    const uint32_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
    load(&f, offsetof(struct seccomp_data, arch));
    add(&f, BPF_JMP | BPF_JEQ | BPF_K, OUR_ARCHITECTURE, 1, 0);
    answer(&f, SECCOMP_RET_KILL_PROCESS);
    load(&f, offsetof(struct seccomp_data, nr));
#ifdef __x86_64__
    add(&f, BPF_JMP | BPF_JGE | BPF_K, 0x40000000u, 0, 1); // calls of the x32 kind
    answer(&f, SECCOMP_RET_KILL_PROCESS);
#endif
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        add(&f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)refused[i], 0, 1);
        answer(&f, REFUSE);
    }
    // its flags are out of reach; without it the C library falls back on clone
    add(&f, BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 0, 1);
    answer(&f, ABSENT);
    refuse_bits(&f, SYS_clone, 0, CLONE_THREAD, true);
    refuse_bits(&f, SYS_openat, 2, writing, false);
#ifdef SYS_open
    refuse_bits(&f, SYS_open, 1, writing, false);
#endif
    answer(&f, SECCOMP_RET_ALLOW);
    const struct sock_fprog program = {.len = f.count, .filter = f.step};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

#else

static bool install_filter(void)
{
    errno = ENOSYS;
    return false;
}

#endif

status seal(int seconds, size_t memory, bool sealed)
{
    bool good = limit(RLIMIT_CPU, (rlim_t)seconds + 1) && limit(RLIMIT_CORE, 0);
    if (memory > 0) {
        good = good && limit(RLIMIT_AS, used_memory() + memory);
    }
    if (sealed) {
        good = good && limit(RLIMIT_NOFILE, MOST_OPEN_FILES) && limit(RLIMIT_FSIZE, 0) &&
               limit(RLIMIT_NPROC, 0) && install_filter();
    }
    return good ? OK
                : status_fail(ERR_RESOURCE, "no limits can be set on a child process: %s",
                              strerror(errno));
}
