#!/usr/bin/env perl
# The controller of my_controller.py as a program of its own, in Perl:
#   testbed run left_tail_fail.yaml --controller ./pilot.pl
# Each line on standard input is one JSON object, and each gets one line back.
use strict;
use warnings;
use JSON::PP;
$| = 1;    # a line is sent when it is written

my $setup = decode_json(scalar <STDIN>);
my ($dt, $pitch_0) = @{$setup}{qw(dt_s trim_pitch)};
my @trim  = map { $_->{trim} } @{ $setup->{actuators} };
my $climb = 0;
die "it flies a v-tail with two motors\n" if @trim != 4;
print "{}\n";

while (my $line = <STDIN>) {
    my $step = decode_json($line);
    my ($y, $r) = @{$step}{qw(sensed reference)};
    my $error = $r->{altitude} - $y->{altitude};
    $climb += 0.02 * $error * $dt;
    my $pitch = $pitch_0 + ($r->{altitude_rate} + 0.5 * $error + $climb) / $y->{airspeed};
    my $elevator = 0.3 * ($y->{pitch} - $pitch) + 0.1 * $y->{q};    # positive trailing edge down: nose down

    my $turn = $r->{heading} - $y->{heading};
    $turn = atan2(sin($turn), cos($turn));
    my $bank = 1.8 * ($r->{heading_rate} + 0.5 * $turn);
    $bank = $bank > 0.4 ? 0.4 : $bank < -0.4 ? -0.4 : $bank;
    my $rudder   = 0.3 * (9.8 / $y->{airspeed} * sin($y->{roll}) + $bank - $y->{roll} - $y->{r});
    my $throttle = 0.1 * ($r->{airspeed} - $y->{airspeed});
    my @mixed    = ($elevator - $rudder, $elevator + $rudder, $throttle, $throttle);
    print encode_json({ step => $step->{step}, commands => [map { $trim[$_] + $mixed[$_] } 0 .. 3] }), "\n";
}
