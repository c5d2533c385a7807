"""Each form of the averaging filter, its heading and its bias is the derived formula again."""

from sympy import (
    Float,
    ImmutableMatrix,
    N,
    Symbol,
    atan2,
    cos,
    exp,
    expand,
    expand_trig,
    log,
    simplify,
    sin,
    sqrt,
    symbols,
)
from sympy.codegen.cfunctions import expm1, log1p
from sympy.logic.boolalg import Boolean

from chr_notes.derivations import averaging as derived
from chr_notes.derivations import estimation, further, hamilton, quaternions, validation
from chr_notes.derivations.computation import Choice, Computation
from chr_notes.derivations.forms import averaging, filters, gains, heading, monitor, rest
from chr_notes.symbols import (
    ACCELEROMETER,
    BODY_RATES,
    EULER,
    MAGNETOMETER,
    QUATERNION,
    T,
    g,
)

FORCES = symbols("force_n force_e force_d", real=True)
TAU = {derived.tau: gains.TIME_CONSTANT}


def same(first: ImmutableMatrix, second: ImmutableMatrix) -> bool:
    return all(simplify(expand(e)) == 0 for e in ImmutableMatrix(first) - ImmutableMatrix(second))


def taken_in() -> Computation:
    steps, means, slopes = averaging._taken_in(FORCES)  # noqa: SLF001
    return Computation(steps, ImmutableMatrix([*means, *slopes]))


def test_each_axis_goes_through_the_low_pass() -> None:
    found = taken_in().inlined(0, 0, 0)
    before = (0, 0, -averaging.LENGTH)  # level: the mean points up
    for axis, mean in enumerate(before):
        values = {
            derived.mean: mean,
            derived.slope: averaging.SLOPES[axis],
            derived.force: FORCES[axis],
            T: averaging.COUNTED,
        }
        step = derived.low_pass_step().xreplace(TAU | values)
        assert same(ImmutableMatrix([found[axis], found[3 + axis]]), step)


def test_the_beginning_is_a_mean_over_the_time() -> None:
    found = taken_in().inlined(0, 0, 1)
    left, step = averaging.LEFT, averaging.COUNTED
    before = ImmutableMatrix([0, 0, -averaging.LENGTH])
    whole = (left * before + step * ImmutableMatrix(FORCES)) / (left + step)
    now = found.subs(averaging.LENGTH_OF_MEAN, left + step)
    assert same(ImmutableMatrix(now[:3]), whole)
    assert list(now[3:]) == [0, 0, 0]


def test_a_sample_is_its_share_of_the_time_and_all_of_no_time() -> None:
    share, length = symbols("share length", real=True)
    choice = averaging.share_of_mean(share, T, length)
    assert Computation((choice,), share).inlined(0) == T / length
    assert Computation((choice,), share).inlined(1) == 1


def test_what_is_not_heard_leaves_the_mean() -> None:
    found = taken_in().inlined(0, 0, 2)
    assert list(found[:3]) == [0, 0, -averaging.LENGTH]


def test_levelling_is_the_derived_turn() -> None:
    attitude = QUATERNION
    means, slopes = symbols("m_n m_e m_d", real=True), symbols("s_n s_e s_d", real=True)
    steps, state = averaging._levelled(attitude, means, slopes)  # noqa: SLF001
    found = Computation(steps, state).inlined(0)
    turn = further.level_turn().xreplace(dict(zip(further.UPWARD, means, strict=True)))
    turn = turn / sqrt(turn.dot(turn))
    expected = hamilton.multiply(ImmutableMatrix(turn), ImmutableMatrix(attitude))
    expected_slopes = hamilton.sandwich(ImmutableMatrix(turn), ImmutableMatrix(slopes))
    values = dict(zip((*attitude, *means, *slopes), (1, -2, 3, 4, 2, 1, -7, 3, -5, 2), strict=True))
    off = ImmutableMatrix([*found[:4], *found[5:]]) - ImmutableMatrix([*expected, *expected_slopes])
    # Numbers in place of symbols: a proof would have to simplify nested roots.
    assert max(abs(N(each.subs(values), 30)) for each in off) < 1e-25
    assert found[4].subs(values) == sqrt(4 + 1 + 49)


def test_the_bound_is_that_of_motion_and_bias() -> None:
    real = {**TAU, derived.t: averaging.AVERAGED, g: averaging.SLOW[g]}
    begun = derived.mean_motion_error() + derived.bias_error()
    run_in = derived.motion_error() + derived.bias_error()
    for branch, expected in ((1, begun), (2, run_in)):
        assert simplify(averaging.bound().inlined(branch, 1) - expected.xreplace(real)) == 0


def test_gains() -> None:
    gain = gains.gain_from_time_constant().inlined(0).replace(expm1, lambda x: exp(x) - 1)
    assert simplify(gain - derived.gain_from_time_constant().xreplace(TAU)) == 0
    constant = gains.time_constant_from_gain().inlined(0).replace(log1p, lambda x: log(1 + x))
    # Every gain from 0 to 1 is one of these, of which the logarithm is known.
    gain = {estimation.L: 1 - exp(-Symbol("u", positive=True))}
    assert simplify((constant - derived.time_constant_from_gain()).subs(gain)) == 0


def test_the_watch_hears_more_then_less_then_as_always() -> None:
    said = [monitor.gain().inlined(branch) for branch in range(3)]
    assert said == [monitor.HIGHEST, monitor.LOWEST, monitor.USUAL]
    counted = [monitor.samples_above().inlined(branch) for branch in range(3)]
    assert counted == [monitor.ABOVE + 1, 0, monitor.ABOVE]


def test_a_bias_is_the_mean_over_a_rest() -> None:
    found = rest.bias().inlined(0, 0, 0)
    before = ImmutableMatrix([*rest.RATE_MEANS, *rest.FORCE_MEANS])
    now = ImmutableMatrix([*BODY_RATES, *ACCELEROMETER])
    mean = (rest.STILL * before + T * now) / (rest.STILL + T)
    assert same(ImmutableMatrix(found[:6]), mean)
    assert expand(found[6] - rest.STILL - T) == 0
    assert list(found[7:]) == list(found[:3])
    assert list(rest.bias().inlined(0, 2, 1)) == [*now, 0, *rest.LEARNT]


def test_a_heading_turns_about_the_vertical() -> None:
    angle = Symbol("angle", real=True)
    steps, about, state = heading._turned_about_down(QUATERNION, angle)  # noqa: SLF001
    turned = Computation(steps, state).inlined()
    # Yaw of the attitude grows by the angle, roll and pitch stay.
    attitude = quaternions.from_euler()
    yaw = EULER[2]
    values = dict(zip(QUATERNION, attitude, strict=True))
    off = turned.xreplace(values) - attitude.subs(yaw, yaw + angle)
    assert all(expand(each, trig=True) == 0 for each in off.applyfunc(expand_trig))
    assert about[1:3] == (0, 0)


def test_the_observer_with_a_magnetometer_shows_its_heading() -> None:
    numbers = (0.5, -0.5, 0.7, 0.1, 0.4, -1.1, 0.3, 1.0, -2.0, -9.0, 20.0, -5.0, 40.0)
    names = (*QUATERNION, *BODY_RATES, *ACCELEROMETER, *MAGNETOMETER)
    values = dict(zip(names, numbers, strict=True)) | {T: 0.1, estimation.L: 0.3}
    values |= dict(zip(validation.REFERENCE[:2], (1, 0), strict=True))
    alone = evaluated(filters.observer_turn(), values, 0, 0, 0, 0)
    before = by_angles(alone)
    said = validation.heading().subs(values | dict(zip(EULER[:2], before[:2], strict=True)))
    off = atan2(sin(said - before[2]), cos(said - before[2]))
    for share in (0, 0.25, 1):
        given = values | {heading.HEADING_GAIN: share}
        after = by_angles(evaluated(heading.observer_turn(), given, 0, 0, 0, 0, 0, 0))
        expected = [*before[:2], before[2] + share * off]
        assert max(abs(N(e - f, 30)) for e, f in zip(after, expected, strict=True)) < 1e-20
    unheard = evaluated(heading.observer_turn(), given, 0, 0, 0, 0, 0, 1)
    assert max(abs(each) for each in unheard - alone) < 1e-25


def evaluated(form: Computation, values: dict[Symbol, float], *branches: int) -> ImmutableMatrix:
    """Compute step by step with thirty digits, by the branches that are asked for."""
    known = {name: N(value, 30) for name, value in values.items()}
    taken = iter(branches)
    for step in form.steps:
        if isinstance(step, Choice):
            chosen = step.branches[next(taken)][1]
            known |= {n: N(v.xreplace(known), 30) for n, v in zip(step.names, chosen, strict=True)}
        elif not isinstance(step.value, Boolean):
            known[step.name] = N(step.value.xreplace(known), 30)
    return form.results.applyfunc(lambda each: N(each.xreplace(known), 30))


def by_angles(quaternion: ImmutableMatrix) -> list[Float]:
    values = dict(zip(QUATERNION, quaternion / sqrt(quaternion.dot(quaternion)), strict=True))
    return [N(each.xreplace(values), 30) for each in quaternions.euler_from_quaternion()]
