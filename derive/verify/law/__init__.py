"""The Definition of a kinematic law, decided: where it holds, where it jumps, where V rises."""
