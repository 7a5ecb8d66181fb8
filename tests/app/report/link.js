// A link opens its statement, also where the filter hides it.
var r = {};
type("flat punch");
location.hash = "#energy-identity";
window.dispatchEvent(new HashChangeEvent("hashchange"));
r.opened = opened();
r.visible = visible().length;
location.hash = "#references";
window.dispatchEvent(new HashChangeEvent("hashchange"));
r.still = opened();
result = JSON.stringify(r);
