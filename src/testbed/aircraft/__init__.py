"""What an aircraft is, as its folder says it: actuators, limits, envelope, and the controller's stored design model."""
