"""What a call must fail with, for the scripts beside this one."""


def fails(kind, words, call, *arguments, **more):
    try:
        call(*arguments, **more)
    except kind as error:
        assert words in str(error), "%r does not say %r" % (str(error), words)
        return error
    raise AssertionError("%s did not fail: %r" % (call, words))
