"use strict";(()=>{function ee(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r===void 0||r===!1||n.setAttribute(s,r===!0?"":String(r));return n.append(...t),n}function Rt(i,e,t={}){let n=ee("button",{type:"button",...t},i);return n.addEventListener("click",e),n}function _t(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element '${i}'`);return e}function lt(i,e){i.textContent!==e&&(i.textContent=e)}function $a(...i){return ee("tr",{},...i.map(e=>ee("td",{},e)))}function Pi(i,...e){let t=ee("tbody"),n=ee("thead",{},ee("tr",{},...e.map(s=>ee("th",{scope:"col"},s))));return{table:ee("table",{},ee("caption",{},i),n,t),body:t}}function Po(i){return i instanceof HTMLElement&&(i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)||i instanceof HTMLInputElement&&!/^(checkbox|radio|button)$/.test(i.type))}function Ff(i,e,t){let n=Rt("Follow",()=>{e.follows=!e.follows,n.setAttribute("aria-pressed",String(e.follows))},{"aria-pressed":"true",title:"The camera goes with the robot"}),s=["behind","front","side","top"];i.append(n,...s.map(r=>Rt(r[0]?.toUpperCase()+r.slice(1),()=>e.lookFrom(r),{title:`Look from ${r}`})),Rt("+",()=>e.zoom(.8),{"aria-label":"Nearer"}),Rt("−",()=>e.zoom(1.25),{"aria-label":"Farther"}),...t?[t.toggle,t.form]:[])}var Of=[700,700,2500],Rr=class{constructor(e,t){this.url=e;this.user=t}socket;timer;tries=0;ended=!1;start(){this.ended=!1,this.tryOnce()}stop(){this.ended=!0,this.drop("")}restart(e){this.drop(e),this.ended||(this.timer=setTimeout(()=>this.tryOnce(),200))}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(e),!0)}tryOnce(){clearTimeout(this.timer);let e=new WebSocket(this.url);e.binaryType="arraybuffer",this.socket=e,this.timer=setTimeout(()=>this.restart("no answer"),Of[this.tries++%Of.length]),e.onopen=()=>{clearTimeout(this.timer),this.tries=0,this.user.opened(e)},e.onmessage=t=>this.user.received(t.data),e.onclose=t=>this.restart(t.reason)}drop(e){clearTimeout(this.timer);let t=this.socket;this.socket=void 0,t&&(t.onopen=t.onmessage=t.onclose=null,t.close(),this.user.closed(e))}};function Yh(i){return`${location.protocol==="https:"?"wss":"ws"}://${location.host}${i}`}var Vs=class extends Error{},Gi=class extends Error{};function zf(i){return i.includes("late: it may have been sent")}function Vf(i){return i.includes("given before a stop")||i.includes("a stop that this connection called later")}var kf=3e3,Bf=1e3,k_=20,Za=class{constructor(e,t){this.token=t;this.keeper=new Rr(e,this)}keeper;waiting=new Map;subscriptions=new Map;lastId=0;open=!1;onOpen=()=>{};onClose=()=>{};onStatus=()=>{};start(){this.keeper.start(),setInterval(()=>void this.probe(),Bf)}get isOpen(){return this.open}call(e,t={},n=kf){return new Promise((s,r)=>{let o=`${e}#${++this.lastId}`;if(!this.keeper.send(JSON.stringify({op:"call_service",id:o,service:e,args:t}))){r(new Gi(`${e} was not sent: there is no connection to the robot`));return}let a=setTimeout(()=>{this.waiting.delete(o),r(new Vs(`${e} was sent, but not answered within ${n/1e3} s`))},n);this.waiting.set(o,{service:e,resolve:s,reject:r,timer:a})})}async order(e,t={},n=kf){let s=await this.call(e,t,n);if(!s.success)throw new Gi(s.message||`${e} was refused`);return s}async stop(e,t={}){let n=this.order(e,t),s=JSON.stringify({op:"call_service",id:`${e}#${this.lastId}`,service:e,args:t}),r=setInterval(()=>this.keeper.send(s),k_);try{return await n}finally{clearInterval(r)}}publish(e,t){return this.keeper.send(JSON.stringify({op:"publish",topic:e,msg:t}))}subscribe(e,t,n,s){let r=this.subscriptions.get(e);r||(r={type:t,throttle_ms:n,takers:new Set},this.subscriptions.set(e,r),this.sendSubscription(e,r));let{takers:o}=r;return o.add(s),()=>{o.delete(s),!(o.size>0||!this.subscriptions.delete(e))&&this.keeper.send(JSON.stringify({op:"unsubscribe",topic:e}))}}opened(){this.open=!0;let e=this.token();e!==void 0&&this.keeper.send(JSON.stringify({op:"auth",token:e}));for(let[t,n]of this.subscriptions)this.sendSubscription(t,n);this.onOpen()}closed(){let e=[...this.waiting.values()];this.waiting.clear();for(let{service:t,reject:n,timer:s}of e)clearTimeout(s),n(new Vs(`${t} was sent, but the connection was lost before its answer`));this.open&&this.onClose(),this.open=!1}received(e){let t=JSON.parse(e);if(t.op==="publish")for(let n of this.subscriptions.get(t.topic)?.takers??[])n(t.msg);else t.op==="service_response"?this.answered(t):t.op==="status"&&this.onStatus(String(t.level),String(t.msg))}answered(e){let t=e.id,n=this.waiting.get(t);n&&(this.waiting.delete(t),clearTimeout(n.timer),e.result===!0?n.resolve(e.values):n.reject(new Gi(String(e.values))))}sendSubscription(e,{type:t,throttle_ms:n}){this.keeper.send(JSON.stringify({op:"subscribe",topic:e,type:t,throttle_rate:n,queue_length:n?1:100}))}async probe(){if(this.open)try{await this.call("/rosapi/get_time",{},Bf)}catch(e){e instanceof Vs&&this.open&&this.keeper.restart("no answer")}}};var Ka=class{constructor(e,t){this.robot=e;this.name=t}name;lease;period_ms=0;kept_ms=0;asking;onChange=()=>{};get mine(){return this.lease!==void 0}take(){return this.asking??=this.ask().finally(()=>this.asking=void 0),this.asking}async giveBack(){let e=this.lease;this.lost(),e!==void 0&&await this.robot.order("/command/release",{lease:e})}lost(){this.lease!==void 0&&(this.lease=void 0,this.onChange())}async keep(e){let t=this.lease;if(!(t===void 0||e-this.kept_ms<this.period_ms)){this.kept_ms=e;try{await this.robot.order("/command/keep_alive",{lease:t})}catch(n){throw this.lease===t&&n instanceof Gi&&this.lost(),n}}}async ask(){let e=await this.robot.order("/command/acquire",{name:this.name});this.lease=String(e.lease),this.period_ms=Number(e.keep_alive_period)*1e3/2,this.kept_ms=performance.now(),this.onChange()}};var Io=class extends Error{};function Wi(i){return i===void 0?{}:{headers:{Authorization:`Bearer ${i}`}}}async function Hf(i){let e=await fetch("robot.json",Wi(i));if(e.status===401)throw new Io(await e.text());if(!e.ok)throw new Error(await e.text());return await e.json()}var us={forward:0,left:0,turn:0},B_=80,z_=400;function $h(i){return i.forward===0&&i.left===0&&i.turn===0}function Gf(i,e){let t=s=>Math.max(-1,Math.min(1,s)),n=t(i.ahead);return{forward:n*(n<0?e.backward:e.forward),left:t(i.left)*e.left,turn:t(i.turn)*e.turn}}var Ja=class{current="rests";wanted=us;sent_ms=-1/0;late_ms=-1/0;lateSince_ms=-1/0;get state(){return this.current}hold(e,t){return this.wanted=e,this.current!=="rests"||$h(e)?!1:(this.current=t?"drives":"waits",this.sent_ms=-1/0,!t)}granted(){this.current==="waits"&&(this.current="drives")}letGo(){let e=this.current==="drives";return this.current="rests",this.wanted=us,e?us:void 0}end(){let e=this.current==="drives";return this.current!=="rests"&&(this.current="blocked"),e}late(e,t){return e-this.late_ms>z_&&(this.lateSince_ms=e),this.late_ms=e,e-this.lateSince_ms>=t&&this.end()}due(e){if(!(this.current!=="drives"||e-this.sent_ms<B_))return this.sent_ms=e,this.wanted}};function Zh({bounds:i}){return{forward:i.forward,backward:i.forward,left:i.forward,turn:i.turn}}function V_(i,e){let t=n=>{let s=Number(i[n]);return Number.isFinite(s)?Math.min(s,e[n]):e[n]};return{forward:t("forward"),backward:t("backward"),left:t("left"),turn:t("turn")}}async function Wf(i,e){return V_(await i.call("/walk/limits"),Zh(e))}var Xf={KeyW:{ahead:1},ArrowUp:{ahead:1},KeyS:{ahead:-1},ArrowDown:{ahead:-1},KeyA:{turn:1},ArrowLeft:{turn:1},KeyD:{turn:-1},ArrowRight:{turn:-1},KeyQ:{left:1},KeyE:{left:-1}},H_=.6,Kh=.15,G_=i=>Math.abs(i)<Kh?0:(i-Math.sign(i)*Kh)/(1-Kh),ja=class{held=new Set;fast=!1;press(e){return this.fast=e.shiftKey,!(e.code in Xf)||e.ctrlKey||e.altKey||e.metaKey||Po(e.target)?!1:(this.held.add(e.code),!0)}release(e){this.fast=e.shiftKey,this.held.delete(e.code)}letGo(){this.held.clear()}get wish(){let e={ahead:0,left:0,turn:0};for(let n of this.held){let s=Xf[n];e.ahead+=s?.ahead??0,e.left+=s?.left??0,e.turn+=s?.turn??0}let t=this.fast?1:H_;return{ahead:Math.sign(e.ahead)*t,left:Math.sign(e.left)*t,turn:Math.sign(e.turn)*t}}},Lo=class{constructor(e,t,n){this.changed=n;this.field=ee("div",{class:`stick ${e}`,role:"img","aria-label":t,title:t},this.knob),this.field.addEventListener("pointerdown",s=>this.grasp(s)),this.field.addEventListener("pointermove",s=>this.move(s));for(let s of["pointerup","pointercancel","lostpointercapture"])this.field.addEventListener(s,r=>r.pointerId===this.pointer&&this.letGo())}field;knob=ee("div",{class:"knob"});pointer;x=0;y=0;letGo(){this.pointer=void 0,this.place(0,0)}mirror(e,t){this.pointer===void 0&&this.draw(e,t)}grasp(e){e.button!==0||this.pointer!==void 0||(e.preventDefault(),this.pointer=e.pointerId,this.field.setPointerCapture(e.pointerId),this.move(e))}move(e){if(e.pointerId!==this.pointer)return;let t=this.field.getBoundingClientRect(),n=Math.min(t.width,t.height)/2-20,s=(e.clientX-t.left-t.width/2)/(this.field.classList.contains("wide")?t.width/2-24:n),r=this.field.classList.contains("wide")?0:-(e.clientY-t.top-t.height/2)/n,o=Math.hypot(s,r);o>1&&(s/=o,r/=o),this.place(s,r)}place(e,t){this.x=e,this.y=t,this.draw(e,t),this.changed()}draw(e,t){this.knob.style.setProperty("--x",String(e)),this.knob.style.setProperty("--y",String(-t))}},Qa=class{stopHeld=!1;onStop=()=>{};get wish(){let e=navigator.getGamepads?.().find(s=>s?.connected);if(!e)return;let t=e.buttons.slice(0,4).some(s=>s.pressed);t&&!this.stopHeld&&this.onStop(),this.stopHeld=t;let n=s=>G_(e.axes[s]??0);return{ahead:-n(1),left:-n(0),turn:-n(2)}}};function qf(i){let e=t=>Math.abs(t.ahead)+Math.abs(t.left)+Math.abs(t.turn);return i.reduce((t,n)=>n&&e(n)>e(t)?n:t,{ahead:0,left:0,turn:0})}var Jh=[{name:"version",type:"uint8",count:1,scale:1},{name:"joint_count",type:"uint8",count:1,scale:1},{name:"frame",type:"uint32",count:1,scale:0},{name:"robot_time",type:"uint32",count:1,scale:.001},{name:"mode",type:"uint8",count:1,scale:1},{name:"activity",type:"uint8",count:1,scale:1},{name:"contact",type:"uint8",count:2,scale:1},{name:"age",type:"uint16",count:5,scale:.001},{name:"round_trip",type:"uint16",count:1,scale:.001},{name:"base_place",type:"int32",count:2,scale:1e-4},{name:"base_height",type:"int16",count:1,scale:1e-4},{name:"base_turn",type:"int16",count:4,scale:3051850947599719e-20},{name:"com",type:"int16",count:3,scale:1e-4},{name:"zmp",type:"int16",count:2,scale:1e-4},{name:"planned_zmp",type:"int16",count:2,scale:1e-4},{name:"foot_force",type:"uint16",count:2,scale:.1},{name:"velocity",type:"int16",count:3,scale:.001},{name:"joint_trouble",type:"uint8",count:5,scale:0},{name:"batches_late",type:"uint16",count:1,scale:0},{name:"batches_refused",type:"uint16",count:1,scale:0},{name:"tails_played",type:"uint16",count:1,scale:0},{name:"footstep_count",type:"uint8",count:1,scale:1},{name:"footstep",type:"int16",count:12,scale:.001},{name:"commander",type:"uint8",count:16,scale:0},{name:"joint",type:"int16",count:0,scale:1e-4}];var Zf={uint8:1,int16:2,uint16:2,int32:4,uint32:4},W_={uint8:255,int16:-32768,uint16:65535,int32:-2147483648,uint32:4294967295},Do=class extends Error{};function X_(i,e,t){switch(e){case"uint8":return i.getUint8(t);case"int16":return i.getInt16(t,!0);case"uint16":return i.getUint16(t,!0);case"int32":return i.getInt32(t,!0);case"uint32":return i.getUint32(t,!0)}}function q_(i,e){return i.scale===0?e:e===W_[i.type]?NaN:e*i.scale}function $f(i){return Jh.reduce((e,t)=>e+Zf[t.type]*(t.count||i),0)}function Kf(i){let e=new DataView(i);if(e.getUint8(0)!==1)throw new Do(`the robot shows layout ${e.getUint8(0)}, this page knows ${1}`);let t=e.getUint8(1);if(i.byteLength!==$f(t))throw new RangeError(`a view frame of ${t} joints has ${$f(t)} bytes, this one ${i.byteLength}`);let n={},s=0;for(let r of Jh){let o=[];for(let a=0;a<(r.count||t);++a)o.push(q_(r,X_(e,r.type,s))),s+=Zf[r.type];n[r.name]=o}return n}function Jf(i){let e=new Uint8Array(4);return new DataView(e.buffer).setUint32(0,i.frame[0]??0,!0),e}function el(i){let e=i.commander.indexOf(0);return new TextDecoder().decode(Uint8Array.from(e<0?i.commander:i.commander.slice(0,e)))}function jf(i,e){return((i.joint_trouble[e>>3]??0)>>(e&7)&1)===1}var ds={batches:0,safeTail:1,holds:2,emergencyStop:3},Qf=["not known","stands","walks","plays a motion","falls","lies"],ep=5,tp=["plays batches","plays a safe tail","holds, waits for a batch","emergency stop"],tl=["joints","pose","message controller","plan","robot's clock"];var Y_=20,$_=2e3,Z_=700,nl=class{constructor(e){this.context=e;this.bounds=Zh(e.description),document.addEventListener("keydown",t=>{this.keys.press(t)&&t.preventDefault(),this.look()}),document.addEventListener("keyup",t=>{this.keys.release(t),this.look()}),window.addEventListener("blur",()=>this.letGo()),window.addEventListener("pagehide",()=>this.leave()),document.addEventListener("visibilitychange",()=>document.hidden&&this.leave()),setInterval(()=>this.look(),Y_)}walk=new Lo("round","Walk: up and down ahead and back, sideways turns. Keys W, A, S, D or arrows.",()=>this.look());side=new Lo("wide","Sidestep to the left and right. Keys Q and E.",()=>this.look());pad=new Qa;keys=new ja;foreignSince_ms;boundsRead_ms=-1/0;boundsKnown=!1;retired=!1;bounds;sent=us;end(){this.context.drive.end()&&this.publish(us)}lost(){let{drive:e,command:t,news:n}=this.context;t.mine&&n.say("The connection was lost, and with it the command.","bad"),e.end(),t.lost(),this.sent=us}late(e){let{drive:t,news:n,description:s}=this.context;t.late(e,s.bounds.velocity_holds*1e3)&&n.say("The drive has ended: what you ask for comes too late, since the connection, or this computer, is slow. Let go of the stick first.","bad")}retire(){this.leave(),this.retired=!0}letGo(){this.keys.letGo(),this.walk.letGo(),this.side.letGo()}leave(){this.letGo(),this.end(),this.context.command.mine&&this.context.command.giveBack().catch(()=>{})}look(){let e=this.pad.wish;if(this.retired)return;let{drive:t,freshness:n,command:s,news:r}=this.context,o=performance.now(),a={ahead:this.walk.y,turn:-this.walk.x,left:-this.side.x},c=qf([a,this.keys.wish,document.hidden?void 0:e]);this.walk.mirror(-c.turn,c.ahead),this.side.mirror(-c.left,0);let l=this.boundsKnown?Gf(c,this.bounds):us;if($h(l)){let h=t.letGo();h&&this.publish(h)}else t.hold(l,s.mine)&&s.take().then(()=>t.granted(),h=>{t.end(),r.say(`You cannot drive: ${h.message}`,"bad")});t.state==="drives"&&n.state(o)==="lost"&&(this.end(),r.say("Nothing comes from the robot any more: the drive has ended. Let go of the stick first.","bad"));let u=t.due(o);u&&this.publish(u),this.keepCommand(o),this.keepBounds(o)}publish({forward:e,left:t,turn:n}){this.sent={forward:e,left:t,turn:n},this.context.robot.publish("/cmd_vel",{linear:{x:e,y:t},angular:{z:n}})}keepCommand(e){let{command:t,freshness:n,news:s,drive:r}=this.context;if(!t.mine){this.foreignSince_ms=void 0;return}t.keep(e).catch(c=>{c instanceof Gi&&(r.end(),s.say("You do not command any more: the robot has not heard from this page in time (is this computer busy?), or somebody has stopped it.","bad"))});let o=n.newest,a=o!==void 0&&n.state(e)!=="lost"&&el(o)!==t.name;this.foreignSince_ms=a?this.foreignSince_ms??e:void 0,!(this.foreignSince_ms===void 0||e-this.foreignSince_ms<Z_)&&(r.end(),t.lost(),s.say("You do not command any more: somebody has stopped the robot, or the connection was too slow.","bad"))}keepBounds(e){let{robot:t,description:n}=this.context;!t.isOpen||document.hidden||e-this.boundsRead_ms<$_||(this.boundsRead_ms=e,Wf(t,n).then(s=>{this.bounds=s,this.boundsKnown=!0},()=>{}))}};var il=class{frame;came_ms=-1/0;connected=!1;outageSince_ms;loss={frames:0,outages:0,longest_ms:0};take(e,t){this.endOutage(t);let n=this.frame?(e.frame[0]??0)-(this.frame.frame[0]??0)-1:0;this.connected&&n>0&&(this.loss.frames+=n),this.connected=!0,this.frame=e,this.came_ms=t}disconnected(e){this.connected&&this.beginOutage(e),this.connected=!1}get newest(){return this.frame}age_ms(e,t){if(!this.frame)return 1/0;let n=(this.frame.age[e]??NaN)*1e3,s=(this.frame.round_trip[0]??NaN)*1e3/2;return Number.isNaN(n)?1/0:n+(Number.isNaN(s)?0:s)+this.sinceCame_ms(t)}sinceCame_ms(e){return e-this.came_ms}pictureAge_ms(e){return Math.max(...[0,1,2,4].map(t=>this.age_ms(t,e)))}state(e){return!this.connected||this.sinceCame_ms(e)>1e3?"lost":this.pictureAge_ms(e)>300?"old":"live"}beginOutage(e){this.outageSince_ms??=Math.min(e,Math.max(this.came_ms,0))}endOutage(e){this.frame&&this.sinceCame_ms(e)>1e3&&this.beginOutage(e),this.outageSince_ms!==void 0&&(this.loss.outages+=1,this.loss.longest_ms=Math.max(this.loss.longest_ms,e-this.outageSince_ms),this.outageSince_ms=void 0)}};function ii(i){return Number.isFinite(i)?i<1e3?`${Math.max(Math.round(i),0)} ms`:i<6e4?`${(i/1e3).toFixed(1)} s`:`${Math.round(i/6e4)} min`:"never"}var jh=i=>i===""?"":i.charAt(0).toUpperCase()+i.slice(1)+(/[.?!]$/.test(i)?"":".");function np({otherVersion:i,link:e,linkTold_ms:t,certificate:n},s){if(i!==void 0)return{text:i,weight:"bad",action:"reload"};if(e&&e.state!=="up"){let o=`For ${ii(e.seconds*1e3+s-t)}.`;return{text:`${jh(`the robot is not there: ${e.text}`)} ${jh(n)}`.trim(),age:o,weight:"bad",action:void 0}}let r=[e?.text??"",n].map(jh).join(" ").trim();return r===""?void 0:{text:r,weight:"caution",action:"hide"}}var sl=class{constructor(e){this.robot=e;e.subscribe("/link_state","gaitway_msgs/msg/LinkState",0,t=>{this.known.link=t,this.known.linkTold_ms=performance.now()}),e.subscribe("/certificate_state","std_msgs/msg/String",0,t=>this.known.certificate=String(t.data)),this.button.addEventListener("click",()=>{this.known.otherVersion!==void 0?location.reload():this.hidden=this.text.textContent??""})}box=_t("trouble");text=_t("trouble-text");age=_t("trouble-age");button=_t("trouble-button");known={linkTold_ms:0,certificate:""};hidden="";otherVersion(e){this.known.otherVersion=e}look(e){this.robot.isOpen||delete this.known.link;let t=np(this.known,e);this.box.hidden=!t||t.action==="hide"&&t.text===this.hidden,t&&(this.box.className=`trouble ${t.weight}`,lt(this.text,t.text),lt(this.age,t.age??""),this.button.hidden=t.action===void 0,lt(this.button,t.action==="reload"?"Load again":"Hide"))}};var K_={good:4e3,plain:6e3,bad:12e3},J_=4,rl=class{constructor(e){this.list=e}say(e,t="plain",n=e){for(let r of[...this.list.children])r instanceof HTMLElement&&r.dataset.about===n&&r.remove();let s=ee("p",{class:t,"data-about":n},e);for(this.list.append(s);this.list.childElementCount>J_;)this.list.firstElementChild?.remove();setTimeout(()=>s.remove(),K_[t])}};function ip([i,e,t,n]){return Math.atan2(2*(i*e+n*t),1-2*(e*e+t*t))}function j_(i,{least:e,most:t}){return Math.min(Math.max(i,e),t)}function sp(i,e,t,n,s){let r=Math.hypot(i,e),o=r<=6,a=j_(o?n:r*1,s),[c,l]=o?[0,1]:[i/r,e/r];return[a*(l*t[0]+c*t[1]),a*(l*t[1]-c*t[0])]}function Qh([i,e],t){let[n,s]=[Math.cos(t),Math.sin(t)];return[n*i+s*e,n*e-s*i]}function eu([i,e]){return Math.hypot(i,e)}function rp(i,[e,t]){return{link:i,force:{x:e,y:t,z:0},duration:.1,frame:"heading"}}var ex=900,tx=[{text:"↑",name:"ahead",force:[1,0]},{text:"↓",name:"back",force:[-1,0]},{text:"←",name:"to its left",force:[0,1]},{text:"→",name:"to its right",force:[0,-1]}],ol=class{constructor(e,t,n,s){this.context=e;this.scene=t;this.canvas=n;this.bounds=s;let{links:r}=e.description;this.link=ee("select",{"aria-label":"Link that is pushed"},...r.map(({name:a})=>ee("option",{},a))),this.newtons=ee("input",{type:"number","aria-label":"Force of a push in newtons",min:Math.ceil(s.least),max:s.most,step:1,value:s.usual}),this.toggle=Rt("Push",()=>this.setOn(!this.on),{"aria-pressed":"false",id:"push",title:"Push the robot: click or drag on a part of it"}),this.form=ee("div",{class:"push-form",role:"group","aria-label":"Push the robot",hidden:!0},this.link,this.newtons,"N",...tx.map(({text:a,name:c,force:l})=>Rt(a,()=>this.pushBy(l),{"aria-label":`Push ${c}`,title:`Push ${c}`}))),n.after(this.label);let o=(a,c)=>n.addEventListener(a,c,{capture:!0});o("pointerdown",a=>this.begin(a)),o("pointermove",a=>this.move(a)),o("pointerup",a=>this.end(a)),o("pointercancel",()=>this.cancel()),n.addEventListener("pointerleave",()=>this.label.hidden=!this.drag),window.addEventListener("keydown",a=>a.key==="Escape"&&this.cancel(),{capture:!0})}toggle;form;link;newtons;label=ee("p",{class:"push-label",role:"status",hidden:!0});drag;shown=0;get on(){return this.toggle.getAttribute("aria-pressed")==="true"}setOn(e){this.toggle.setAttribute("aria-pressed",String(e)),this.form.hidden=!e,this.canvas.classList.toggle("pushes",e),!e&&(this.cancel(),this.label.hidden=!0)}begin(e){if(this.drag){this.cancel();return}let t=this.on&&e.button===0?this.scene.gripAt(e.clientX,e.clientY):void 0;t&&(e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId),this.link.selectedIndex=t.link,this.drag={pointer:e.pointerId,x:e.clientX,y:e.clientY,grip:t,force:[0,0]},this.move(e))}move(e){if(this.drag||this.tellLink(e),e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{x:t,y:n,grip:s}=this.drag;this.drag.force=sp(e.clientX-t,n-e.clientY,this.scene.away(),this.chosen_N,this.bounds),this.showArrow(s,this.drag.force),this.tell(e,`${this.linkName(s.link)}: ${eu(this.drag.force).toFixed(0)} N`)}tellLink(e){let t=this.on&&e.buttons===0?this.scene.gripAt(e.clientX,e.clientY):void 0;this.label.hidden=!t,t&&this.tell(e,this.linkName(t.link))}tell(e,t){lt(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}end(e){if(e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{grip:t,force:n}=this.drag;this.drag=void 0,this.label.hidden=!0,this.push(t,Qh(n,this.heading()))}cancel(){this.drag&&(this.drag=void 0,this.label.hidden=!0,this.scene.hidePush())}pushBy([e,t]){let n=this.chosen_N;this.push(this.scene.gripOn(this.link.selectedIndex),[e*n,t*n])}push(e,t){if(!e)return;this.showArrow(e,Qh(t,-this.heading()));let n=this.shown;setTimeout(()=>n===this.shown&&this.scene.hidePush(),ex);let s=this.linkName(e.link);this.context.attempt(`Push of ${s}, ${eu(t).toFixed(0)} N for ${.1} s`,()=>this.context.robot.order("/simulation/push",rp(s,t)))}showArrow(e,t){this.shown+=1,this.scene.showPush(e,t)}get chosen_N(){let{least:e,most:t,usual:n}=this.bounds;return Math.min(Math.max(Number(this.newtons.value)||n,e),t)}heading(){let{x:e,y:t,z:n,w:s}=this.scene.body.base.quaternion;return ip([e,t,n,s])}linkName(e){return this.context.description.links[e]?.name??""}};/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Cs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Rs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Op=0,Vu=1,kp=2;var Hu=1,Bp=2,Ui=3,ji=0,Un=1,Fi=2,es=0,Ys=1,Gu=2,Wu=3,Xu=4,zp=5,bs=100,Vp=101,Hp=102,Gp=103,Wp=104,Xp=200,qp=201,Yp=202,$p=203,Il=204,Ll=205,Zp=206,Kp=207,Jp=208,jp=209,Qp=210,em=211,tm=212,nm=213,im=214,ac=0,lc=1,cc=2,$s=3,hc=4,uc=5,dc=6,fc=7,pc=0,sm=1,rm=2,ts=0,om=1,am=2,lm=3,cm=4,hm=5,um=6,dm=7;var qu=300,rr=301,or=302,mc=303,gc=304,Sa=306,Dl=1e3,ys=1001,Nl=1002,oi=1003,fm=1004;var wa=1005;var xi=1006,_c=1007;var Ps=1008;var yi=1009,Yu=1010,$u=1011,no=1012,xc=1013,Is=1014,Oi=1015,io=1016,vc=1017,yc=1018,so=1020,Zu=35902,Ku=35899,Ju=1021,ju=1022,ai=1023,Xr=1026,ro=1027,Qu=1028,bc=1029,ed=1030,Mc=1031;var Sc=1033,Ea=33776,Ta=33777,Aa=33778,Ca=33779,wc=35840,Ec=35841,Tc=35842,Ac=35843,Cc=36196,Rc=37492,Pc=37496,Ic=37808,Lc=37809,Dc=37810,Nc=37811,Uc=37812,Fc=37813,Oc=37814,kc=37815,Bc=37816,zc=37817,Vc=37818,Hc=37819,Gc=37820,Wc=37821,Xc=36492,qc=36494,Yc=36495,$c=36283,Zc=36284,Kc=36285,Jc=36286;var Wo=2300,Ul=2301,Pl=2302,Au=2400,Cu=2401,Ru=2402;var pm=3200,mm=3201;var td=0,gm=1,ns="",vn="srgb",Zs="srgb-linear",Xo="linear",Et="srgb";var qs=7680;var Pu=519,_m=512,xm=513,vm=514,nd=515,ym=516,bm=517,Mm=518,Sm=519,Iu=35044;var id="300 es",_i=2e3,qo=2001;var Ii=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],op=1234567,zo=Math.PI/180,qr=180/Math.PI;function ar(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(wn[i&255]+wn[i>>8&255]+wn[i>>16&255]+wn[i>>24&255]+"-"+wn[e&255]+wn[e>>8&255]+"-"+wn[e>>16&15|64]+wn[e>>24&255]+"-"+wn[t&63|128]+wn[t>>8&255]+"-"+wn[t>>16&255]+wn[t>>24&255]+wn[n&255]+wn[n>>8&255]+wn[n>>16&255]+wn[n>>24&255]).toLowerCase()}function ot(i,e,t){return Math.max(e,Math.min(t,i))}function sd(i,e){return(i%e+e)%e}function nx(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function ix(i,e,t){return i!==e?(t-i)/(e-i):0}function Vo(i,e,t){return(1-t)*i+t*e}function sx(i,e,t,n){return Vo(i,e,1-Math.exp(-t*n))}function rx(i,e=1){return e-Math.abs(sd(i,e*2)-e)}function ox(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function ax(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function lx(i,e){return i+Math.floor(Math.random()*(e-i+1))}function cx(i,e){return i+Math.random()*(e-i)}function hx(i){return i*(.5-Math.random())}function ux(i){i!==void 0&&(op=i);let e=op+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function dx(i){return i*zo}function fx(i){return i*qr}function px(i){return(i&i-1)===0&&i!==0}function mx(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function gx(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function _x(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),c=o(t/2),l=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,c*h,c*d,a*l);break;case"YZY":i.set(c*d,a*u,c*h,a*l);break;case"ZXZ":i.set(c*h,c*d,a*u,a*l);break;case"XZX":i.set(a*u,c*g,c*f,a*l);break;case"YXY":i.set(c*f,a*u,c*g,a*l);break;case"ZYZ":i.set(c*g,c*f,a*u,a*l);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Hr(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Dn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Ra={DEG2RAD:zo,RAD2DEG:qr,generateUUID:ar,clamp:ot,euclideanModulo:sd,mapLinear:nx,inverseLerp:ix,lerp:Vo,damp:sx,pingpong:rx,smoothstep:ox,smootherstep:ax,randInt:lx,randFloat:cx,randFloatSpread:hx,seededRandom:ux,degToRad:dx,radToDeg:fx,isPowerOfTwo:px,ceilPowerOfTwo:mx,floorPowerOfTwo:gx,setQuaternionFromProperEuler:_x,normalize:Dn,denormalize:Hr},be=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],x=r[o+3];if(a===0){e[t+0]=c,e[t+1]=l,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=d,e[t+1]=f,e[t+2]=g,e[t+3]=x;return}if(h!==x||c!==d||l!==f||u!==g){let m=1-a,p=c*d+l*f+u*g+h*x,M=p>=0?1:-1,S=1-p*p;if(S>Number.EPSILON){let P=Math.sqrt(S),A=Math.atan2(P,p*M);m=Math.sin(m*A)/P,a=Math.sin(a*A)/P}let v=a*M;if(c=c*m+d*v,l=l*m+f*v,u=u*m+g*v,h=h*m+x*v,m===1-a){let P=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=P,l*=P,u*=P,h*=P}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+c*f-l*d,e[t+1]=c*g+u*d+l*h-a*f,e[t+2]=l*g+u*f+a*d-c*h,e[t+3]=u*g-a*h-c*d-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),h=a(r/2),d=c(n/2),f=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"YZX":this._x=d*u*h+l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h-d*f*g;break;case"XZY":this._x=d*u*h-l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h+d*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ot(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,u=t._w;return this._x=n*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let c=1-a*a;if(c<=Number.EPSILON){let f=1-t;return this._w=f*o+t*this._w,this._x=f*n+t*this._x,this._y=f*s+t*this._y,this._z=f*r+t*this._z,this.normalize(),this}let l=Math.sqrt(c),u=Math.atan2(l,a),h=Math.sin((1-t)*u)/l,d=Math.sin(t*u)/l;return this._w=o*h+this._w*d,this._x=n*h+this._x*d,this._y=s*h+this._y*d,this._z=r*h+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ap.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ap.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+c*l+o*h-a*u,this.y=n+c*u+a*l-r*h,this.z=s+c*h+r*u-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return tu.copy(this).projectOnVector(e),this.sub(tu)}reflect(e){return this.sub(tu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ot(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},tu=new O,ap=new yn,st=class i{constructor(e,t,n,s,r,o,a,c,l){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],h=n[7],d=n[2],f=n[5],g=n[8],x=s[0],m=s[3],p=s[6],M=s[1],S=s[4],v=s[7],P=s[2],A=s[5],D=s[8];return r[0]=o*x+a*M+c*P,r[3]=o*m+a*S+c*A,r[6]=o*p+a*v+c*D,r[1]=l*x+u*M+h*P,r[4]=l*m+u*S+h*A,r[7]=l*p+u*v+h*D,r[2]=d*x+f*M+g*P,r[5]=d*m+f*S+g*A,r[8]=d*p+f*v+g*D,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8];return t*o*u-t*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],h=u*o-a*l,d=a*c-u*r,f=l*r-o*c,g=t*h+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=h*x,e[1]=(s*l-u*n)*x,e[2]=(a*n-s*o)*x,e[3]=d*x,e[4]=(u*t-s*c)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(n*c-l*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(nu.makeScale(e,t)),this}rotate(e){return this.premultiply(nu.makeRotation(-e)),this}translate(e,t){return this.premultiply(nu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},nu=new st;function rd(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Yo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function wm(){let i=Yo("canvas");return i.style.display="block",i}var lp={};function Yr(i){i in lp||(lp[i]=!0,console.warn(i))}function Em(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var cp=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),hp=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function xx(){let i={enabled:!0,workingColorSpace:Zs,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Et&&(s.r=Ji(s.r),s.g=Ji(s.g),s.b=Ji(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Et&&(s.r=Gr(s.r),s.g=Gr(s.g),s.b=Gr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ns?Xo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Yr("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Yr("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Zs]:{primaries:e,whitePoint:n,transfer:Xo,toXYZ:cp,fromXYZ:hp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vn},outputColorSpaceConfig:{drawingBufferColorSpace:vn}},[vn]:{primaries:e,whitePoint:n,transfer:Et,toXYZ:cp,fromXYZ:hp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vn}}}),i}var ft=xx();function Ji(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Gr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Pr,Fl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Pr===void 0&&(Pr=Yo("canvas")),Pr.width=e.width,Pr.height=e.height;let s=Pr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Pr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Yo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ji(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ji(t[n]/255)*255):t[n]=Ji(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},vx=0,$r=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:vx++}),this.uuid=ar(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(iu(s[o].image)):r.push(iu(s[o]))}else r=iu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function iu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Fl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var yx=0,su=new O,qn=class i extends Ii{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ys,s=ys,r=xi,o=Ps,a=ai,c=yi,l=i.DEFAULT_ANISOTROPY,u=ns){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yx++}),this.uuid=ar(),this.name="",this.source=new $r(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new be(0,0),this.repeat=new be(1,1),this.center=new be(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(su).x}get height(){return this.source.getSize(su).y}get depth(){return this.source.getSize(su).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==qu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Dl:e.x=e.x-Math.floor(e.x);break;case ys:e.x=e.x<0?0:1;break;case Nl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Dl:e.y=e.y-Math.floor(e.y);break;case ys:e.y=e.y<0?0:1;break;case Nl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};qn.DEFAULT_IMAGE=null;qn.DEFAULT_MAPPING=qu;qn.DEFAULT_ANISOTROPY=1;var $t=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],u=c[4],h=c[8],d=c[1],f=c[5],g=c[9],x=c[2],m=c[6],p=c[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(g+m)<.1&&Math.abs(l+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(l+1)/2,v=(f+1)/2,P=(p+1)/2,A=(u+d)/4,D=(h+x)/4,F=(g+m)/4;return S>v&&S>P?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=A/n,r=D/n):v>P?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=A/s,r=F/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=D/r,s=F/r),this.set(n,s,r,t),this}let M=Math.sqrt((m-g)*(m-g)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(h-x)/M,this.z=(d-u)/M,this.w=Math.acos((l+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ot(this.x,e.x,t.x),this.y=ot(this.y,e.y,t.y),this.z=ot(this.z,e.z,t.z),this.w=ot(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ot(this.x,e,t),this.y=ot(this.y,e,t),this.z=ot(this.z,e,t),this.w=ot(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ot(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ol=class extends Ii{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new $t(0,0,e,t),this.scissorTest=!1,this.viewport=new $t(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new qn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new $r(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Li=class extends Ol{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$o=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=ys,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var kl=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=ys,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Di=class{constructor(e=new O(1/0,1/0,1/0),t=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(pi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(pi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=pi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,pi):pi.fromBufferAttribute(r,o),pi.applyMatrix4(e.matrixWorld),this.expandByPoint(pi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),al.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),al.copy(n.boundingBox)),al.applyMatrix4(e.matrixWorld),this.union(al)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,pi),pi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(No),ll.subVectors(this.max,No),Ir.subVectors(e.a,No),Lr.subVectors(e.b,No),Dr.subVectors(e.c,No),fs.subVectors(Lr,Ir),ps.subVectors(Dr,Lr),Hs.subVectors(Ir,Dr);let t=[0,-fs.z,fs.y,0,-ps.z,ps.y,0,-Hs.z,Hs.y,fs.z,0,-fs.x,ps.z,0,-ps.x,Hs.z,0,-Hs.x,-fs.y,fs.x,0,-ps.y,ps.x,0,-Hs.y,Hs.x,0];return!ru(t,Ir,Lr,Dr,ll)||(t=[1,0,0,0,1,0,0,0,1],!ru(t,Ir,Lr,Dr,ll))?!1:(cl.crossVectors(fs,ps),t=[cl.x,cl.y,cl.z],ru(t,Ir,Lr,Dr,ll))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,pi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(pi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Xi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Xi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Xi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Xi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Xi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Xi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Xi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Xi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Xi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Xi=[new O,new O,new O,new O,new O,new O,new O,new O],pi=new O,al=new Di,Ir=new O,Lr=new O,Dr=new O,fs=new O,ps=new O,Hs=new O,No=new O,ll=new O,cl=new O,Gs=new O;function ru(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Gs.fromArray(i,r);let a=s.x*Math.abs(Gs.x)+s.y*Math.abs(Gs.y)+s.z*Math.abs(Gs.z),c=e.dot(Gs),l=t.dot(Gs),u=n.dot(Gs);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var bx=new Di,Uo=new O,ou=new O,Ks=class{constructor(e=new O,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):bx.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Uo.subVectors(e,this.center);let t=Uo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Uo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ou.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Uo.copy(e.center).add(ou)),this.expandByPoint(Uo.copy(e.center).sub(ou))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qi=new O,au=new O,hl=new O,ms=new O,lu=new O,ul=new O,cu=new O,Ms=class{constructor(e=new O,t=new O(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,qi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=qi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(qi.copy(this.origin).addScaledVector(this.direction,t),qi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){au.copy(e).add(t).multiplyScalar(.5),hl.copy(t).sub(e).normalize(),ms.copy(this.origin).sub(au);let r=e.distanceTo(t)*.5,o=-this.direction.dot(hl),a=ms.dot(this.direction),c=-ms.dot(hl),l=ms.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*c-a,d=o*a-c,g=r*u,h>=0)if(d>=-g)if(d<=g){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*c)+l}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l):d<=g?(h=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(au).addScaledVector(hl,d),f}intersectSphere(e,t){qi.subVectors(e.center,this.origin);let n=qi.dot(this.direction),s=qi.dot(qi)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return l>=0?(n=(e.min.x-d.x)*l,s=(e.max.x-d.x)*l):(n=(e.max.x-d.x)*l,s=(e.min.x-d.x)*l),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,c=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,c=(e.min.z-d.z)*h),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,qi)!==null}intersectTriangle(e,t,n,s,r){lu.subVectors(t,e),ul.subVectors(n,e),cu.crossVectors(lu,ul);let o=this.direction.dot(cu),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ms.subVectors(this.origin,e);let c=a*this.direction.dot(ul.crossVectors(ms,ul));if(c<0)return null;let l=a*this.direction.dot(lu.cross(ms));if(l<0||c+l>o)return null;let u=-a*ms.dot(cu);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Pt=class i{constructor(e,t,n,s,r,o,a,c,l,u,h,d,f,g,x,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,u,h,d,f,g,x,m)}set(e,t,n,s,r,o,a,c,l,u,h,d,f,g,x,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=g,p[11]=x,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Nr.setFromMatrixColumn(e,0).length(),r=1/Nr.setFromMatrixColumn(e,1).length(),o=1/Nr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,x=a*h;t[0]=c*u,t[4]=-c*h,t[8]=l,t[1]=f+g*l,t[5]=d-x*l,t[9]=-a*c,t[2]=x-d*l,t[6]=g+f*l,t[10]=o*c}else if(e.order==="YXZ"){let d=c*u,f=c*h,g=l*u,x=l*h;t[0]=d+x*a,t[4]=g*a-f,t[8]=o*l,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=x+d*a,t[10]=o*c}else if(e.order==="ZXY"){let d=c*u,f=c*h,g=l*u,x=l*h;t[0]=d-x*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,x=a*h;t[0]=c*u,t[4]=g*l-f,t[8]=d*l+x,t[1]=c*h,t[5]=x*l+d,t[9]=f*l-g,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let d=o*c,f=o*l,g=a*c,x=a*l;t[0]=c*u,t[4]=x-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-l*u,t[6]=f*h+g,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*c,f=o*l,g=a*c,x=a*l;t[0]=c*u,t[4]=-h,t[8]=l*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Mx,e,Sx)}lookAt(e,t,n){let s=this.elements;return Wn.subVectors(e,t),Wn.lengthSq()===0&&(Wn.z=1),Wn.normalize(),gs.crossVectors(n,Wn),gs.lengthSq()===0&&(Math.abs(n.z)===1?Wn.x+=1e-4:Wn.z+=1e-4,Wn.normalize(),gs.crossVectors(n,Wn)),gs.normalize(),dl.crossVectors(Wn,gs),s[0]=gs.x,s[4]=dl.x,s[8]=Wn.x,s[1]=gs.y,s[5]=dl.y,s[9]=Wn.y,s[2]=gs.z,s[6]=dl.z,s[10]=Wn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],h=n[5],d=n[9],f=n[13],g=n[2],x=n[6],m=n[10],p=n[14],M=n[3],S=n[7],v=n[11],P=n[15],A=s[0],D=s[4],F=s[8],T=s[12],w=s[1],C=s[5],k=s[9],V=s[13],W=s[2],X=s[6],q=s[10],j=s[14],$=s[3],ae=s[7],le=s[11],xe=s[15];return r[0]=o*A+a*w+c*W+l*$,r[4]=o*D+a*C+c*X+l*ae,r[8]=o*F+a*k+c*q+l*le,r[12]=o*T+a*V+c*j+l*xe,r[1]=u*A+h*w+d*W+f*$,r[5]=u*D+h*C+d*X+f*ae,r[9]=u*F+h*k+d*q+f*le,r[13]=u*T+h*V+d*j+f*xe,r[2]=g*A+x*w+m*W+p*$,r[6]=g*D+x*C+m*X+p*ae,r[10]=g*F+x*k+m*q+p*le,r[14]=g*T+x*V+m*j+p*xe,r[3]=M*A+S*w+v*W+P*$,r[7]=M*D+S*C+v*X+P*ae,r[11]=M*F+S*k+v*q+P*le,r[15]=M*T+S*V+v*j+P*xe,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],x=e[7],m=e[11],p=e[15];return g*(+r*c*h-s*l*h-r*a*d+n*l*d+s*a*f-n*c*f)+x*(+t*c*f-t*l*d+r*o*d-s*o*f+s*l*u-r*c*u)+m*(+t*l*h-t*a*f-r*o*h+n*o*f+r*a*u-n*l*u)+p*(-s*a*u-t*c*h+t*a*d+s*o*h-n*o*d+n*c*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],x=e[13],m=e[14],p=e[15],M=h*m*l-x*d*l+x*c*f-a*m*f-h*c*p+a*d*p,S=g*d*l-u*m*l-g*c*f+o*m*f+u*c*p-o*d*p,v=u*x*l-g*h*l+g*a*f-o*x*f-u*a*p+o*h*p,P=g*h*c-u*x*c-g*a*d+o*x*d+u*a*m-o*h*m,A=t*M+n*S+s*v+r*P;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/A;return e[0]=M*D,e[1]=(x*d*r-h*m*r-x*s*f+n*m*f+h*s*p-n*d*p)*D,e[2]=(a*m*r-x*c*r+x*s*l-n*m*l-a*s*p+n*c*p)*D,e[3]=(h*c*r-a*d*r-h*s*l+n*d*l+a*s*f-n*c*f)*D,e[4]=S*D,e[5]=(u*m*r-g*d*r+g*s*f-t*m*f-u*s*p+t*d*p)*D,e[6]=(g*c*r-o*m*r-g*s*l+t*m*l+o*s*p-t*c*p)*D,e[7]=(o*d*r-u*c*r+u*s*l-t*d*l-o*s*f+t*c*f)*D,e[8]=v*D,e[9]=(g*h*r-u*x*r-g*n*f+t*x*f+u*n*p-t*h*p)*D,e[10]=(o*x*r-g*a*r+g*n*l-t*x*l-o*n*p+t*a*p)*D,e[11]=(u*a*r-o*h*r-u*n*l+t*h*l+o*n*f-t*a*f)*D,e[12]=P*D,e[13]=(u*x*s-g*h*s+g*n*d-t*x*d-u*n*m+t*h*m)*D,e[14]=(g*a*s-o*x*s-g*n*c+t*x*c+o*n*m-t*a*m)*D,e[15]=(o*h*s-u*a*s+u*n*c-t*h*c-o*n*d+t*a*d)*D,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,u=o+o,h=a+a,d=r*l,f=r*u,g=r*h,x=o*u,m=o*h,p=a*h,M=c*l,S=c*u,v=c*h,P=n.x,A=n.y,D=n.z;return s[0]=(1-(x+p))*P,s[1]=(f+v)*P,s[2]=(g-S)*P,s[3]=0,s[4]=(f-v)*A,s[5]=(1-(d+p))*A,s[6]=(m+M)*A,s[7]=0,s[8]=(g+S)*D,s[9]=(m-M)*D,s[10]=(1-(d+x))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Nr.set(s[0],s[1],s[2]).length(),o=Nr.set(s[4],s[5],s[6]).length(),a=Nr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],mi.copy(this);let l=1/r,u=1/o,h=1/a;return mi.elements[0]*=l,mi.elements[1]*=l,mi.elements[2]*=l,mi.elements[4]*=u,mi.elements[5]*=u,mi.elements[6]*=u,mi.elements[8]*=h,mi.elements[9]*=h,mi.elements[10]*=h,t.setFromRotationMatrix(mi),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=_i,c=!1){let l=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,x;if(c)g=r/(o-r),x=o*r/(o-r);else if(a===_i)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===qo)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=_i,c=!1){let l=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,x;if(c)g=1/(o-r),x=o/(o-r);else if(a===_i)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===qo)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Nr=new O,mi=new Pt,Mx=new O(0,0,0),Sx=new O(1,1,1),gs=new O,dl=new O,Wn=new O,up=new Pt,dp=new yn,Yn=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ot(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ot(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ot(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ot(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ot(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ot(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return up.makeRotationFromQuaternion(e),this.setFromRotationMatrix(up,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return dp.setFromEuler(this),this.setFromQuaternion(dp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Yn.DEFAULT_ORDER="XYZ";var Zr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},wx=0,fp=new O,Ur=new yn,Yi=new Pt,fl=new O,Fo=new O,Ex=new O,Tx=new yn,pp=new O(1,0,0),mp=new O(0,1,0),gp=new O(0,0,1),_p={type:"added"},Ax={type:"removed"},Fr={type:"childadded",child:null},hu={type:"childremoved",child:null},bn=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:wx++}),this.uuid=ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new O,t=new Yn,n=new yn,s=new O(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Pt},normalMatrix:{value:new st}}),this.matrix=new Pt,this.matrixWorld=new Pt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Zr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ur.setFromAxisAngle(e,t),this.quaternion.multiply(Ur),this}rotateOnWorldAxis(e,t){return Ur.setFromAxisAngle(e,t),this.quaternion.premultiply(Ur),this}rotateX(e){return this.rotateOnAxis(pp,e)}rotateY(e){return this.rotateOnAxis(mp,e)}rotateZ(e){return this.rotateOnAxis(gp,e)}translateOnAxis(e,t){return fp.copy(e).applyQuaternion(this.quaternion),this.position.add(fp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(pp,e)}translateY(e){return this.translateOnAxis(mp,e)}translateZ(e){return this.translateOnAxis(gp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Yi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?fl.copy(e):fl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Fo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Yi.lookAt(Fo,fl,this.up):Yi.lookAt(fl,Fo,this.up),this.quaternion.setFromRotationMatrix(Yi),s&&(Yi.extractRotation(s.matrixWorld),Ur.setFromRotationMatrix(Yi),this.quaternion.premultiply(Ur.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(_p),Fr.child=e,this.dispatchEvent(Fr),Fr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ax),hu.child=e,this.dispatchEvent(hu),hu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Yi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Yi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Yi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(_p),Fr.child=e,this.dispatchEvent(Fr),Fr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fo,e,Ex),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fo,Tx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];r(e.shapes,h)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};bn.DEFAULT_UP=new O(0,1,0);bn.DEFAULT_MATRIX_AUTO_UPDATE=!0;bn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var gi=new O,$i=new O,uu=new O,Zi=new O,Or=new O,kr=new O,xp=new O,du=new O,fu=new O,pu=new O,mu=new $t,gu=new $t,_u=new $t,vs=class i{constructor(e=new O,t=new O,n=new O){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),gi.subVectors(e,t),s.cross(gi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){gi.subVectors(s,t),$i.subVectors(n,t),uu.subVectors(e,t);let o=gi.dot(gi),a=gi.dot($i),c=gi.dot(uu),l=$i.dot($i),u=$i.dot(uu),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(l*c-a*u)*d,g=(o*u-a*c)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Zi)===null?!1:Zi.x>=0&&Zi.y>=0&&Zi.x+Zi.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,Zi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Zi.x),c.addScaledVector(o,Zi.y),c.addScaledVector(a,Zi.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return mu.setScalar(0),gu.setScalar(0),_u.setScalar(0),mu.fromBufferAttribute(e,t),gu.fromBufferAttribute(e,n),_u.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(mu,r.x),o.addScaledVector(gu,r.y),o.addScaledVector(_u,r.z),o}static isFrontFacing(e,t,n,s){return gi.subVectors(n,t),$i.subVectors(e,t),gi.cross($i).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return gi.subVectors(this.c,this.b),$i.subVectors(this.a,this.b),gi.cross($i).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Or.subVectors(s,n),kr.subVectors(r,n),du.subVectors(e,n);let c=Or.dot(du),l=kr.dot(du);if(c<=0&&l<=0)return t.copy(n);fu.subVectors(e,s);let u=Or.dot(fu),h=kr.dot(fu);if(u>=0&&h<=u)return t.copy(s);let d=c*h-u*l;if(d<=0&&c>=0&&u<=0)return o=c/(c-u),t.copy(n).addScaledVector(Or,o);pu.subVectors(e,r);let f=Or.dot(pu),g=kr.dot(pu);if(g>=0&&f<=g)return t.copy(r);let x=f*l-c*g;if(x<=0&&l>=0&&g<=0)return a=l/(l-g),t.copy(n).addScaledVector(kr,a);let m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return xp.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(xp,a);let p=1/(m+x+d);return o=x*p,a=d*p,t.copy(n).addScaledVector(Or,o).addScaledVector(kr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Tm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},_s={h:0,s:0,l:0},pl={h:0,s:0,l:0};function xu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var tt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ft.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=ft.workingColorSpace){return this.r=e,this.g=t,this.b=n,ft.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=ft.workingColorSpace){if(e=sd(e,1),t=ot(t,0,1),n=ot(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=xu(o,r,e+1/3),this.g=xu(o,r,e),this.b=xu(o,r,e-1/3)}return ft.colorSpaceToWorking(this,s),this}setStyle(e,t=vn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vn){let n=Tm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ji(e.r),this.g=Ji(e.g),this.b=Ji(e.b),this}copyLinearToSRGB(e){return this.r=Gr(e.r),this.g=Gr(e.g),this.b=Gr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vn){return ft.workingToColorSpace(En.copy(this),e),Math.round(ot(En.r*255,0,255))*65536+Math.round(ot(En.g*255,0,255))*256+Math.round(ot(En.b*255,0,255))}getHexString(e=vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ft.workingColorSpace){ft.workingToColorSpace(En.copy(this),t);let n=En.r,s=En.g,r=En.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case n:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-n)/h+2;break;case r:c=(n-s)/h+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=ft.workingColorSpace){return ft.workingToColorSpace(En.copy(this),t),e.r=En.r,e.g=En.g,e.b=En.b,e}getStyle(e=vn){ft.workingToColorSpace(En.copy(this),e);let t=En.r,n=En.g,s=En.b;return e!==vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(_s),this.setHSL(_s.h+e,_s.s+t,_s.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(_s),e.getHSL(pl);let n=Vo(_s.h,pl.h,t),s=Vo(_s.s,pl.s,t),r=Vo(_s.l,pl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},En=new tt;tt.NAMES=Tm;var Cx=0,Qi=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Cx++}),this.uuid=ar(),this.name="",this.type="Material",this.blending=Ys,this.side=ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Il,this.blendDst=Ll,this.blendEquation=bs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new tt(0,0,0),this.blendAlpha=0,this.depthFunc=$s,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Pu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=qs,this.stencilZFail=qs,this.stencilZPass=qs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Ys&&(n.blending=this.blending),this.side!==ji&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Il&&(n.blendSrc=this.blendSrc),this.blendDst!==Ll&&(n.blendDst=this.blendDst),this.blendEquation!==bs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==$s&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Pu&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==qs&&(n.stencilFail=this.stencilFail),this.stencilZFail!==qs&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==qs&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Ni=class extends Qi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yn,this.combine=pc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var Qt=new O,ml=new be,Rx=0,nn=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Rx++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Iu,this.updateRanges=[],this.gpuType=Oi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)ml.fromBufferAttribute(this,t),ml.applyMatrix3(e),this.setXY(t,ml.x,ml.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyMatrix3(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyMatrix4(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyNormalMatrix(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.transformDirection(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Hr(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Dn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Hr(t,this.array)),t}setX(e,t){return this.normalized&&(t=Dn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Hr(t,this.array)),t}setY(e,t){return this.normalized&&(t=Dn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Hr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Dn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Hr(t,this.array)),t}setW(e,t){return this.normalized&&(t=Dn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Dn(t,this.array),n=Dn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Dn(t,this.array),n=Dn(n,this.array),s=Dn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Dn(t,this.array),n=Dn(n,this.array),s=Dn(s,this.array),r=Dn(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Iu&&(e.usage=this.usage),e}};var Zo=class extends nn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ko=class extends nn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Tt=class extends nn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Px=0,si=new Pt,vu=new bn,Br=new O,Xn=new Di,Oo=new Di,mn=new O,Jt=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Px++}),this.uuid=ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(rd(e)?Ko:Zo)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return si.makeRotationFromQuaternion(e),this.applyMatrix4(si),this}rotateX(e){return si.makeRotationX(e),this.applyMatrix4(si),this}rotateY(e){return si.makeRotationY(e),this.applyMatrix4(si),this}rotateZ(e){return si.makeRotationZ(e),this.applyMatrix4(si),this}translate(e,t,n){return si.makeTranslation(e,t,n),this.applyMatrix4(si),this}scale(e,t,n){return si.makeScale(e,t,n),this.applyMatrix4(si),this}lookAt(e){return vu.lookAt(e),vu.updateMatrix(),this.applyMatrix4(vu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Br).negate(),this.translate(Br.x,Br.y,Br.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Tt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Di);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Xn.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,Xn.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,Xn.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint(Xn.min),this.boundingBox.expandByPoint(Xn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ks);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(e){let n=this.boundingSphere.center;if(Xn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Oo.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors(Xn.min,Oo.min),Xn.expandByPoint(mn),mn.addVectors(Xn.max,Oo.max),Xn.expandByPoint(mn)):(Xn.expandByPoint(Oo.min),Xn.expandByPoint(Oo.max))}Xn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)mn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(mn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)mn.fromBufferAttribute(a,l),c&&(Br.fromBufferAttribute(e,l),mn.add(Br)),s=Math.max(s,n.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new nn(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],c=[];for(let F=0;F<n.count;F++)a[F]=new O,c[F]=new O;let l=new O,u=new O,h=new O,d=new be,f=new be,g=new be,x=new O,m=new O;function p(F,T,w){l.fromBufferAttribute(n,F),u.fromBufferAttribute(n,T),h.fromBufferAttribute(n,w),d.fromBufferAttribute(r,F),f.fromBufferAttribute(r,T),g.fromBufferAttribute(r,w),u.sub(l),h.sub(l),f.sub(d),g.sub(d);let C=1/(f.x*g.y-g.x*f.y);isFinite(C)&&(x.copy(u).multiplyScalar(g.y).addScaledVector(h,-f.y).multiplyScalar(C),m.copy(h).multiplyScalar(f.x).addScaledVector(u,-g.x).multiplyScalar(C),a[F].add(x),a[T].add(x),a[w].add(x),c[F].add(m),c[T].add(m),c[w].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let F=0,T=M.length;F<T;++F){let w=M[F],C=w.start,k=w.count;for(let V=C,W=C+k;V<W;V+=3)p(e.getX(V+0),e.getX(V+1),e.getX(V+2))}let S=new O,v=new O,P=new O,A=new O;function D(F){P.fromBufferAttribute(s,F),A.copy(P);let T=a[F];S.copy(T),S.sub(P.multiplyScalar(P.dot(T))).normalize(),v.crossVectors(A,T);let C=v.dot(c[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,C)}for(let F=0,T=M.length;F<T;++F){let w=M[F],C=w.start,k=w.count;for(let V=C,W=C+k;V<W;V+=3)D(e.getX(V+0)),D(e.getX(V+1)),D(e.getX(V+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new nn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new O,r=new O,o=new O,a=new O,c=new O,l=new O,u=new O,h=new O;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),c.fromBufferAttribute(n,x),l.fromBufferAttribute(n,m),a.add(u),c.add(u),l.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(x,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)mn.fromBufferAttribute(e,t),mn.normalize(),e.setXYZ(t,mn.x,mn.y,mn.z)}toNonIndexed(){function e(a,c){let l=a.array,u=a.itemSize,h=a.normalized,d=new l.constructor(c.length*u),f=0,g=0;for(let x=0,m=c.length;x<m;x++){a.isInterleavedBufferAttribute?f=c[x]*a.data.stride+a.offset:f=c[x]*u;for(let p=0;p<u;p++)d[g++]=l[f++]}return new nn(d,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,h=l.length;u<h;u++){let d=l[u],f=e(d,n);c.push(f)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,d=l.length;h<d;h++){let f=l[h];u.push(f.toJSON(e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(t))}let r=e.morphAttributes;for(let l in r){let u=[],h=r[l];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},vp=new Pt,Ws=new Ms,gl=new Ks,yp=new O,_l=new O,xl=new O,vl=new O,yu=new O,yl=new O,bp=new O,bl=new O,Wt=class extends bn{constructor(e=new Jt,t=new Ni){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){yl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],h=r[c];u!==0&&(yu.fromBufferAttribute(h,e),o?yl.addScaledVector(yu,u):yl.addScaledVector(yu.sub(t),u))}t.add(yl)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),gl.copy(n.boundingSphere),gl.applyMatrix4(r),Ws.copy(e.ray).recast(e.near),!(gl.containsPoint(Ws.origin)===!1&&(Ws.intersectSphere(gl,yp)===null||Ws.origin.distanceToSquared(yp)>(e.far-e.near)**2))&&(vp.copy(r).invert(),Ws.copy(e.ray).applyMatrix4(vp),!(n.boundingBox!==null&&Ws.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ws)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let m=d[g],p=o[m.materialIndex],M=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=M,P=S;v<P;v+=3){let A=a.getX(v),D=a.getX(v+1),F=a.getX(v+2);s=Ml(this,p,e,n,l,u,h,A,D,F),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=g,p=x;m<p;m+=3){let M=a.getX(m),S=a.getX(m+1),v=a.getX(m+2);s=Ml(this,o,e,n,l,u,h,M,S,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let m=d[g],p=o[m.materialIndex],M=Math.max(m.start,f.start),S=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let v=M,P=S;v<P;v+=3){let A=v,D=v+1,F=v+2;s=Ml(this,p,e,n,l,u,h,A,D,F),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(c.count,f.start+f.count);for(let m=g,p=x;m<p;m+=3){let M=m,S=m+1,v=m+2;s=Ml(this,o,e,n,l,u,h,M,S,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Ix(i,e,t,n,s,r,o,a){let c;if(e.side===Un?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===ji,a),c===null)return null;bl.copy(a),bl.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(bl);return l<t.near||l>t.far?null:{distance:l,point:bl.clone(),object:i}}function Ml(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,_l),i.getVertexPosition(c,xl),i.getVertexPosition(l,vl);let u=Ix(i,e,t,n,_l,xl,vl,bp);if(u){let h=new O;vs.getBarycoord(bp,_l,xl,vl,h),s&&(u.uv=vs.getInterpolatedAttribute(s,a,c,l,h,new be)),r&&(u.uv1=vs.getInterpolatedAttribute(r,a,c,l,h,new be)),o&&(u.normal=vs.getInterpolatedAttribute(o,a,c,l,h,new O),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new O,materialIndex:0};vs.getNormal(_l,xl,vl,d.normal),u.face=d,u.barycoord=h}return u}var Ss=class i extends Jt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new Tt(l,3)),this.setAttribute("normal",new Tt(u,3)),this.setAttribute("uv",new Tt(h,2));function g(x,m,p,M,S,v,P,A,D,F,T){let w=v/D,C=P/F,k=v/2,V=P/2,W=A/2,X=D+1,q=F+1,j=0,$=0,ae=new O;for(let le=0;le<q;le++){let xe=le*C-V;for(let Me=0;Me<X;Me++){let _e=Me*w-k;ae[x]=_e*M,ae[m]=xe*S,ae[p]=W,l.push(ae.x,ae.y,ae.z),ae[x]=0,ae[m]=0,ae[p]=A>0?1:-1,u.push(ae.x,ae.y,ae.z),h.push(Me/D),h.push(1-le/F),j+=1}}for(let le=0;le<F;le++)for(let xe=0;xe<D;xe++){let Me=d+xe+X*le,_e=d+xe+X*(le+1),nt=d+(xe+1)+X*(le+1),Je=d+(xe+1)+X*le;c.push(Me,_e,Je),c.push(_e,nt,Je),$+=6}a.addGroup(f,$,T),f+=$,d+=j}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function lr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Tn(i){let e={};for(let t=0;t<i.length;t++){let n=lr(i[t]);for(let s in n)e[s]=n[s]}return e}function Lx(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function od(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ft.workingColorSpace}var Am={clone:lr,merge:Tn},Dx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Nx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vi=class extends Qi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Dx,this.fragmentShader=Nx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=lr(e.uniforms),this.uniformsGroups=Lx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},Jo=class extends bn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Pt,this.projectionMatrix=new Pt,this.projectionMatrixInverse=new Pt,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},xs=new O,Mp=new be,Sp=new be,gn=class extends Jo{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=qr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(zo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return qr*2*Math.atan(Math.tan(zo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){xs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(xs.x,xs.y).multiplyScalar(-e/xs.z),xs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(xs.x,xs.y).multiplyScalar(-e/xs.z)}getViewSize(e,t){return this.getViewBounds(e,Mp,Sp),t.subVectors(Sp,Mp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(zo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},zr=-90,Vr=1,Bl=class extends bn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new gn(zr,Vr,e,t);s.layers=this.layers,this.add(s);let r=new gn(zr,Vr,e,t);r.layers=this.layers,this.add(r);let o=new gn(zr,Vr,e,t);o.layers=this.layers,this.add(o);let a=new gn(zr,Vr,e,t);a.layers=this.layers,this.add(a);let c=new gn(zr,Vr,e,t);c.layers=this.layers,this.add(c);let l=new gn(zr,Vr,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===_i)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===qo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,c),e.setRenderTarget(n,4,s),e.render(t,l),n.texture.generateMipmaps=x,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jo=class extends qn{constructor(e=[],t=rr,n,s,r,o,a,c,l,u){super(e,t,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},zl=class extends Li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new jo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ss(5,5,5),r=new vi({name:"CubemapFromEquirect",uniforms:lr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Un,blending:es});r.uniforms.tEquirect.value=t;let o=new Wt(s,r),a=t.minFilter;return t.minFilter===Ps&&(t.minFilter=xi),new Bl(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Nn=class extends bn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ux={type:"move"},Kr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Nn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Nn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Nn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,n),p=this._getHandJoint(l,x);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.rotation,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ux)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Nn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var Qo=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new tt(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Js=class extends bn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Yn,this.environmentIntensity=1,this.environmentRotation=new Yn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};var bu=new O,Fx=new O,Ox=new st,ri=class{constructor(e=new O(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=bu.subVectors(n,t).cross(Fx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(bu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Ox.getNormalMatrix(e),s=this.coplanarPoint(bu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Xs=new Ks,kx=new be(.5,.5),Sl=new O,Jr=class{constructor(e=new ri,t=new ri,n=new ri,s=new ri,r=new ri,o=new ri){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=_i,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],x=r[9],m=r[10],p=r[11],M=r[12],S=r[13],v=r[14],P=r[15];if(s[0].setComponents(l-o,f-u,p-g,P-M).normalize(),s[1].setComponents(l+o,f+u,p+g,P+M).normalize(),s[2].setComponents(l+a,f+h,p+x,P+S).normalize(),s[3].setComponents(l-a,f-h,p-x,P-S).normalize(),n)s[4].setComponents(c,d,m,v).normalize(),s[5].setComponents(l-c,f-d,p-m,P-v).normalize();else if(s[4].setComponents(l-c,f-d,p-m,P-v).normalize(),t===_i)s[5].setComponents(l+c,f+d,p+m,P+v).normalize();else if(t===qo)s[5].setComponents(c,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Xs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Xs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Xs)}intersectsSprite(e){Xs.center.set(0,0,0);let t=kx.distanceTo(e.center);return Xs.radius=.7071067811865476+t,Xs.applyMatrix4(e.matrixWorld),this.intersectsSphere(Xs)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Sl.x=s.normal.x>0?e.max.x:e.min.x,Sl.y=s.normal.y>0?e.max.y:e.min.y,Sl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Sl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var ws=class extends Qi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new tt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Vl=new O,Hl=new O,wp=new Pt,ko=new Ms,wl=new Ks,Mu=new O,Ep=new O,js=class extends bn{constructor(e=new Jt,t=new ws){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Vl.fromBufferAttribute(t,s-1),Hl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Vl.distanceTo(Hl);e.setAttribute("lineDistance",new Tt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),wl.copy(n.boundingSphere),wl.applyMatrix4(s),wl.radius+=r,e.ray.intersectsSphere(wl)===!1)return;wp.copy(s).invert(),ko.copy(e.ray).applyMatrix4(wp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=f,m=g-1;x<m;x+=l){let p=u.getX(x),M=u.getX(x+1),S=El(this,e,ko,c,p,M,x);S&&t.push(S)}if(this.isLineLoop){let x=u.getX(g-1),m=u.getX(f),p=El(this,e,ko,c,x,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let x=f,m=g-1;x<m;x+=l){let p=El(this,e,ko,c,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){let x=El(this,e,ko,c,g-1,f,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function El(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Vl.fromBufferAttribute(a,s),Hl.fromBufferAttribute(a,r),t.distanceSqToSegment(Vl,Hl,Mu,Ep)>n)return;Mu.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Mu);if(!(l<e.near||l>e.far))return{distance:l,point:Ep.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Tp=new O,Ap=new O,Gl=class extends js{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Tp.fromBufferAttribute(t,s),Ap.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Tp.distanceTo(Ap);e.setAttribute("lineDistance",new Tt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ea=class extends js{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var ta=class extends qn{constructor(e,t,n=Is,s,r,o,a=oi,c=oi,l,u=Xr,h=1){if(u!==Xr&&u!==ro)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new $r(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},na=class extends qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var ia=class i extends Jt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],c=[],l=new O,u=new be;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let h=0,d=3;h<=t;h++,d+=3){let f=n+h/t*s;l.x=e*Math.cos(f),l.y=e*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),u.x=(o[d]/e+1)/2,u.y=(o[d+1]/e+1)/2,c.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Tt(o,3)),this.setAttribute("normal",new Tt(a,3)),this.setAttribute("uv",new Tt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},Es=class i extends Jt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,x=[],m=n/2,p=0;M(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new Tt(h,3)),this.setAttribute("normal",new Tt(d,3)),this.setAttribute("uv",new Tt(f,2));function M(){let v=new O,P=new O,A=0,D=(t-e)/n;for(let F=0;F<=r;F++){let T=[],w=F/r,C=w*(t-e)+e;for(let k=0;k<=s;k++){let V=k/s,W=V*c+a,X=Math.sin(W),q=Math.cos(W);P.x=C*X,P.y=-w*n+m,P.z=C*q,h.push(P.x,P.y,P.z),v.set(X,D,q).normalize(),d.push(v.x,v.y,v.z),f.push(V,1-w),T.push(g++)}x.push(T)}for(let F=0;F<s;F++)for(let T=0;T<r;T++){let w=x[T][F],C=x[T+1][F],k=x[T+1][F+1],V=x[T][F+1];(e>0||T!==0)&&(u.push(w,C,V),A+=3),(t>0||T!==r-1)&&(u.push(C,k,V),A+=3)}l.addGroup(p,A,0),p+=A}function S(v){let P=g,A=new be,D=new O,F=0,T=v===!0?e:t,w=v===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,m*w,0),d.push(0,w,0),f.push(.5,.5),g++;let C=g;for(let k=0;k<=s;k++){let W=k/s*c+a,X=Math.cos(W),q=Math.sin(W);D.x=T*q,D.y=m*w,D.z=T*X,h.push(D.x,D.y,D.z),d.push(0,w,0),A.x=X*.5+.5,A.y=q*.5*w+.5,f.push(A.x,A.y),g++}for(let k=0;k<s;k++){let V=P+k,W=C+k;v===!0?u.push(W,W+1,V):u.push(W+1,W,V),F+=3}l.addGroup(p,F,v===!0?1:2),p+=F}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},sa=class i extends Es{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var $n=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,c=r-1,l;for(;a<=c;)if(s=Math.floor(a+(c-a)/2),l=n[s]-o,l<0)a=s+1;else if(l>0)c=s-1;else{c=s;break}if(s=c,n[s]===o)return s/(r-1);let u=n[s],d=n[s+1]-u,f=(o-u)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),c=t||(o.isVector2?new be:new O);return c.copy(a).sub(o).normalize(),c}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new O,s=[],r=[],o=[],a=new O,c=new Pt;for(let f=0;f<=e;f++){let g=f/e;s[f]=this.getTangentAt(g,new O)}r[0]=new O,o[0]=new O;let l=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),d=Math.abs(s[0].z);u<=l&&(l=u,n.set(1,0,0)),h<=l&&(l=h,n.set(0,1,0)),d<=l&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(ot(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(c.makeRotationAxis(a,g))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(ot(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let g=1;g<=e;g++)r[g].applyMatrix4(c.makeRotationAxis(s[g],f*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},jr=class extends $n{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,c=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=c}getPoint(e,t=new be){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,c=this.aX+this.xRadius*Math.cos(a),l=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),d=c-this.aX,f=l-this.aY;c=d*u-f*h+this.aX,l=d*h+f*u+this.aY}return n.set(c,l)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Wl=class extends jr{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function ad(){let i=0,e=0,t=0,n=0;function s(r,o,a,c){i=r,e=a,t=-3*r+3*o-2*a-c,n=2*r-2*o+a+c}return{initCatmullRom:function(r,o,a,c,l){s(o,a,l*(a-r),l*(c-o))},initNonuniformCatmullRom:function(r,o,a,c,l,u,h){let d=(o-r)/l-(a-r)/(l+u)+(a-o)/u,f=(a-o)/u-(c-o)/(u+h)+(c-a)/h;d*=u,f*=u,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var Tl=new O,Su=new ad,wu=new ad,Eu=new ad,Xl=class extends $n{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new O){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),c=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:c===0&&a===r-1&&(a=r-2,c=1);let l,u;this.closed||a>0?l=s[(a-1)%r]:(Tl.subVectors(s[0],s[1]).add(s[0]),l=Tl);let h=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(Tl.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=Tl),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,g=Math.pow(l.distanceToSquared(h),f),x=Math.pow(h.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(u),f);x<1e-4&&(x=1),g<1e-4&&(g=x),m<1e-4&&(m=x),Su.initNonuniformCatmullRom(l.x,h.x,d.x,u.x,g,x,m),wu.initNonuniformCatmullRom(l.y,h.y,d.y,u.y,g,x,m),Eu.initNonuniformCatmullRom(l.z,h.z,d.z,u.z,g,x,m)}else this.curveType==="catmullrom"&&(Su.initCatmullRom(l.x,h.x,d.x,u.x,this.tension),wu.initCatmullRom(l.y,h.y,d.y,u.y,this.tension),Eu.initCatmullRom(l.z,h.z,d.z,u.z,this.tension));return n.set(Su.calc(c),wu.calc(c),Eu.calc(c)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new O().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Cp(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,c=i*a;return(2*t-2*n+r+o)*c+(-3*t+3*n-2*r-o)*a+r*i+t}function Bx(i,e){let t=1-i;return t*t*e}function zx(i,e){return 2*(1-i)*i*e}function Vx(i,e){return i*i*e}function Ho(i,e,t,n){return Bx(i,e)+zx(i,t)+Vx(i,n)}function Hx(i,e){let t=1-i;return t*t*t*e}function Gx(i,e){let t=1-i;return 3*t*t*i*e}function Wx(i,e){return 3*(1-i)*i*i*e}function Xx(i,e){return i*i*i*e}function Go(i,e,t,n,s){return Hx(i,e)+Gx(i,t)+Wx(i,n)+Xx(i,s)}var ra=class extends $n{constructor(e=new be,t=new be,n=new be,s=new be){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new be){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Go(e,s.x,r.x,o.x,a.x),Go(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ql=class extends $n{constructor(e=new O,t=new O,n=new O,s=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new O){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Go(e,s.x,r.x,o.x,a.x),Go(e,s.y,r.y,o.y,a.y),Go(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},oa=class extends $n{constructor(e=new be,t=new be){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new be){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new be){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Yl=class extends $n{constructor(e=new O,t=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new O){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new O){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},aa=class extends $n{constructor(e=new be,t=new be,n=new be){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new be){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ho(e,s.x,r.x,o.x),Ho(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},$l=class extends $n{constructor(e=new O,t=new O,n=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new O){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ho(e,s.x,r.x,o.x),Ho(e,s.y,r.y,o.y),Ho(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},la=class extends $n{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new be){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,c=s[o===0?o:o-1],l=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(Cp(a,c.x,l.x,u.x,h.x),Cp(a,c.y,l.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new be().fromArray(s))}return this}},Rp=Object.freeze({__proto__:null,ArcCurve:Wl,CatmullRomCurve3:Xl,CubicBezierCurve:ra,CubicBezierCurve3:ql,EllipseCurve:jr,LineCurve:oa,LineCurve3:Yl,QuadraticBezierCurve:aa,QuadraticBezierCurve3:$l,SplineCurve:la}),Zl=class extends $n{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Rp[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],c=a.getLength(),l=c===0?0:1-o/c;return a.getPointAt(l,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,c=o.getPoints(a);for(let l=0;l<c.length;l++){let u=c[l];n&&n.equals(u)||(t.push(u),n=u)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new Rp[s.type]().fromJSON(s))}return this}},ca=class extends Zl{constructor(e){super(),this.type="Path",this.currentPoint=new be,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new oa(this.currentPoint.clone(),new be(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new aa(this.currentPoint.clone(),new be(e,t),new be(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new ra(this.currentPoint.clone(),new be(e,t),new be(n,s),new be(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new la(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,c=this.currentPoint.y;return this.absarc(e+a,t+c,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,c){let l=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(e+l,t+u,n,s,r,o,a,c),this}absellipse(e,t,n,s,r,o,a,c){let l=new jr(e,t,n,s,r,o,a,c);if(this.curves.length>0){let h=l.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(l);let u=l.getPoint(1);return this.currentPoint.copy(u),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Qr=class extends ca{constructor(e){super(e),this.uuid=ar(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new ca().fromJSON(s))}return this}};function qx(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=Cm(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,c,l;if(n&&(r=Jx(i,e,r,t)),i.length>80*t){a=1/0,c=1/0;let u=-1/0,h=-1/0;for(let d=t;d<s;d+=t){let f=i[d],g=i[d+1];f<a&&(a=f),g<c&&(c=g),f>u&&(u=f),g>h&&(h=g)}l=Math.max(u-a,h-c),l=l!==0?32767/l:0}return ha(r,o,t,a,c,l,0),o}function Cm(i,e,t,n,s){let r;if(s===lv(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=Pp(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=Pp(o/n|0,i[o],i[o+1],r);return r&&eo(r,r.next)&&(da(r),r=r.next),r}function Qs(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(eo(t,t.next)||Yt(t.prev,t,t.next)===0)){if(da(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function ha(i,e,t,n,s,r,o){if(!i)return;!o&&r&&nv(i,n,s,r);let a=i;for(;i.prev!==i.next;){let c=i.prev,l=i.next;if(r?$x(i,n,s,r):Yx(i)){e.push(c.i,i.i,l.i),da(i),i=l.next,a=l.next;continue}if(i=l,i===a){o?o===1?(i=Zx(Qs(i),e),ha(i,e,t,n,s,r,2)):o===2&&Kx(i,e,t,n,s,r):ha(Qs(i),e,t,n,s,r,1);break}}}function Yx(i){let e=i.prev,t=i,n=i.next;if(Yt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,c=t.y,l=n.y,u=Math.min(s,r,o),h=Math.min(a,c,l),d=Math.max(s,r,o),f=Math.max(a,c,l),g=n.next;for(;g!==e;){if(g.x>=u&&g.x<=d&&g.y>=h&&g.y<=f&&Bo(s,a,r,c,o,l,g.x,g.y)&&Yt(g.prev,g,g.next)>=0)return!1;g=g.next}return!0}function $x(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Yt(s,r,o)>=0)return!1;let a=s.x,c=r.x,l=o.x,u=s.y,h=r.y,d=o.y,f=Math.min(a,c,l),g=Math.min(u,h,d),x=Math.max(a,c,l),m=Math.max(u,h,d),p=Lu(f,g,e,t,n),M=Lu(x,m,e,t,n),S=i.prevZ,v=i.nextZ;for(;S&&S.z>=p&&v&&v.z<=M;){if(S.x>=f&&S.x<=x&&S.y>=g&&S.y<=m&&S!==s&&S!==o&&Bo(a,u,c,h,l,d,S.x,S.y)&&Yt(S.prev,S,S.next)>=0||(S=S.prevZ,v.x>=f&&v.x<=x&&v.y>=g&&v.y<=m&&v!==s&&v!==o&&Bo(a,u,c,h,l,d,v.x,v.y)&&Yt(v.prev,v,v.next)>=0))return!1;v=v.nextZ}for(;S&&S.z>=p;){if(S.x>=f&&S.x<=x&&S.y>=g&&S.y<=m&&S!==s&&S!==o&&Bo(a,u,c,h,l,d,S.x,S.y)&&Yt(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;v&&v.z<=M;){if(v.x>=f&&v.x<=x&&v.y>=g&&v.y<=m&&v!==s&&v!==o&&Bo(a,u,c,h,l,d,v.x,v.y)&&Yt(v.prev,v,v.next)>=0)return!1;v=v.nextZ}return!0}function Zx(i,e){let t=i;do{let n=t.prev,s=t.next.next;!eo(n,s)&&Pm(n,t,t.next,s)&&ua(n,s)&&ua(s,n)&&(e.push(n.i,t.i,s.i),da(t),da(t.next),t=i=s),t=t.next}while(t!==i);return Qs(t)}function Kx(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&rv(o,a)){let c=Im(o,a);o=Qs(o,o.next),c=Qs(c,c.next),ha(o,e,t,n,s,r,0),ha(c,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Jx(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,c=r<o-1?e[r+1]*n:i.length,l=Cm(i,a,c,n,!1);l===l.next&&(l.steiner=!0),s.push(sv(l))}s.sort(jx);for(let r=0;r<s.length;r++)t=Qx(s[r],t);return t}function jx(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function Qx(i,e){let t=ev(i,e);if(!t)return e;let n=Im(t,i);return Qs(n,n.next),Qs(t,t.next)}function ev(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(eo(i,t))return t;do{if(eo(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let h=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(h<=n&&h>r&&(r=h,o=t.x<t.next.x?t:t.next,h===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,c=o.x,l=o.y,u=1/0;t=o;do{if(n>=t.x&&t.x>=c&&n!==t.x&&Rm(s<l?n:r,s,c,l,s<l?r:n,s,t.x,t.y)){let h=Math.abs(s-t.y)/(n-t.x);ua(t,i)&&(h<u||h===u&&(t.x>o.x||t.x===o.x&&tv(o,t)))&&(o=t,u=h)}t=t.next}while(t!==a);return o}function tv(i,e){return Yt(i.prev,i,e.prev)<0&&Yt(e.next,i,i.next)<0}function nv(i,e,t,n){let s=i;do s.z===0&&(s.z=Lu(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,iv(s)}function iv(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let l=0;l<t&&(a++,o=o.nextZ,!!o);l++);let c=t;for(;a>0||c>0&&o;)a!==0&&(c===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,c--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function Lu(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function sv(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function Rm(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Bo(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&Rm(i,e,t,n,s,r,o,a)}function rv(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!ov(i,e)&&(ua(i,e)&&ua(e,i)&&av(i,e)&&(Yt(i.prev,i,e.prev)||Yt(i,e.prev,e))||eo(i,e)&&Yt(i.prev,i,i.next)>0&&Yt(e.prev,e,e.next)>0)}function Yt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function eo(i,e){return i.x===e.x&&i.y===e.y}function Pm(i,e,t,n){let s=Cl(Yt(i,e,t)),r=Cl(Yt(i,e,n)),o=Cl(Yt(t,n,i)),a=Cl(Yt(t,n,e));return!!(s!==r&&o!==a||s===0&&Al(i,t,e)||r===0&&Al(i,n,e)||o===0&&Al(t,i,n)||a===0&&Al(t,e,n))}function Al(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function Cl(i){return i>0?1:i<0?-1:0}function ov(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&Pm(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function ua(i,e){return Yt(i.prev,i,i.next)<0?Yt(i,e,i.next)>=0&&Yt(i,i.prev,e)>=0:Yt(i,e,i.prev)<0||Yt(i,i.next,e)<0}function av(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function Im(i,e){let t=Du(i.i,i.x,i.y),n=Du(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function Pp(i,e,t,n){let s=Du(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function da(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Du(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function lv(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Nu=class{static triangulate(e,t,n=2){return qx(e,t,n)}},Wr=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];Ip(e),Lp(n,e);let o=e.length;t.forEach(Ip);for(let c=0;c<t.length;c++)s.push(o),o+=t[c].length,Lp(n,t[c]);let a=Nu.triangulate(n,s);for(let c=0;c<a.length;c+=3)r.push(a.slice(c,c+3));return r}};function Ip(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function Lp(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var fa=class i extends Jt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+1,h=e/a,d=t/c,f=[],g=[],x=[],m=[];for(let p=0;p<u;p++){let M=p*d-o;for(let S=0;S<l;S++){let v=S*h-r;g.push(v,-M,0),x.push(0,0,1),m.push(S/a),m.push(1-p/c)}}for(let p=0;p<c;p++)for(let M=0;M<a;M++){let S=M+l*p,v=M+l*(p+1),P=M+1+l*(p+1),A=M+1+l*p;f.push(S,v,A),f.push(v,P,A)}this.setIndex(f),this.setAttribute("position",new Tt(g,3)),this.setAttribute("normal",new Tt(x,3)),this.setAttribute("uv",new Tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var pa=class i extends Jt{constructor(e=new Qr([new be(0,.5),new be(-.5,-.5),new be(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,c=0;if(Array.isArray(e)===!1)l(e);else for(let u=0;u<e.length;u++)l(e[u]),this.addGroup(a,c,u),a+=c,c=0;this.setIndex(n),this.setAttribute("position",new Tt(s,3)),this.setAttribute("normal",new Tt(r,3)),this.setAttribute("uv",new Tt(o,2));function l(u){let h=s.length/3,d=u.extractPoints(t),f=d.shape,g=d.holes;Wr.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,p=g.length;m<p;m++){let M=g[m];Wr.isClockWise(M)===!0&&(g[m]=M.reverse())}let x=Wr.triangulateShape(f,g);for(let m=0,p=g.length;m<p;m++){let M=g[m];f=f.concat(M)}for(let m=0,p=f.length;m<p;m++){let M=f[m];s.push(M.x,M.y,0),r.push(0,0,1),o.push(M.x,M.y)}for(let m=0,p=x.length;m<p;m++){let M=x[m],S=M[0]+h,v=M[1]+h,P=M[2]+h;n.push(S,v,P),c+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return cv(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function cv(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var ma=class i extends Jt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new O,d=new O,f=[],g=[],x=[],m=[];for(let p=0;p<=n;p++){let M=[],S=p/n,v=0;p===0&&o===0?v=.5/t:p===n&&c===Math.PI&&(v=-.5/t);for(let P=0;P<=t;P++){let A=P/t;h.x=-e*Math.cos(s+A*r)*Math.sin(o+S*a),h.y=e*Math.cos(o+S*a),h.z=e*Math.sin(s+A*r)*Math.sin(o+S*a),g.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(A+v,1-S),M.push(l++)}u.push(M)}for(let p=0;p<n;p++)for(let M=0;M<t;M++){let S=u[p][M+1],v=u[p][M],P=u[p+1][M],A=u[p+1][M+1];(p!==0||o>0)&&f.push(S,v,A),(p!==n-1||c<Math.PI)&&f.push(v,P,A)}this.setIndex(f),this.setAttribute("position",new Tt(g,3)),this.setAttribute("normal",new Tt(x,3)),this.setAttribute("uv",new Tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var ga=class extends Qi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new tt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=td,this.normalScale=new be(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yn,this.combine=pc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Kl=class extends Qi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=pm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Jl=class extends Qi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Rl(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function hv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var er=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},jl=class extends er{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Au,endingEnd:Au}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Cu:r=e,a=2*t-n;break;case Ru:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Cu:o=e,c=2*n-t;break;case Ru:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,u=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),x=g*g,m=x*g,p=-d*m+2*d*x-d*g,M=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*g+1,S=(-1-f)*m+(1.5+f)*x+.5*g,v=f*m-f*x;for(let P=0;P!==a;++P)r[P]=p*o[u+P]+M*o[l+P]+S*o[c+P]+v*o[h+P];return r}},Ql=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[l+d]*h+o[c+d]*u;return r}},ec=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Zn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Rl(t,this.TimeBufferType),this.values=Rl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Rl(e.times,Array),values:Rl(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ql(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new jl(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case Wo:t=this.InterpolantFactoryMethodDiscrete;break;case Ul:t=this.InterpolantFactoryMethodLinear;break;case Pl:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Wo;case this.InterpolantFactoryMethodLinear:return Ul;case this.InterpolantFactoryMethodSmooth:return Pl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&hv(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Pl,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],u=e[a+1];if(l!==u&&(a!==1||l!==e[0]))if(s)c=!0;else{let h=a*n,d=h-n,f=h+n;for(let g=0;g!==n;++g){let x=t[h+g];if(x!==t[d+g]||x!==t[f+g]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Zn.prototype.ValueTypeName="";Zn.prototype.TimeBufferType=Float32Array;Zn.prototype.ValueBufferType=Float32Array;Zn.prototype.DefaultInterpolation=Ul;var Ts=class extends Zn{constructor(e,t,n){super(e,t,n)}};Ts.prototype.ValueTypeName="bool";Ts.prototype.ValueBufferType=Array;Ts.prototype.DefaultInterpolation=Wo;Ts.prototype.InterpolantFactoryMethodLinear=void 0;Ts.prototype.InterpolantFactoryMethodSmooth=void 0;var tc=class extends Zn{constructor(e,t,n,s){super(e,t,n,s)}};tc.prototype.ValueTypeName="color";var nc=class extends Zn{constructor(e,t,n,s){super(e,t,n,s)}};nc.prototype.ValueTypeName="number";var ic=class extends er{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let u=l+a;l!==u;l+=4)yn.slerpFlat(r,0,o,l-a,o,l,c);return r}},_a=class extends Zn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new ic(this.times,this.values,this.getValueSize(),e)}};_a.prototype.ValueTypeName="quaternion";_a.prototype.InterpolantFactoryMethodSmooth=void 0;var As=class extends Zn{constructor(e,t,n){super(e,t,n)}};As.prototype.ValueTypeName="string";As.prototype.ValueBufferType=Array;As.prototype.DefaultInterpolation=Wo;As.prototype.InterpolantFactoryMethodLinear=void 0;As.prototype.InterpolantFactoryMethodSmooth=void 0;var sc=class extends Zn{constructor(e,t,n,s){super(e,t,n,s)}};sc.prototype.ValueTypeName="vector";var Uu={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(this.files[i]=e)},get:function(i){if(this.enabled!==!1)return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}},rc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=l.length;h<d;h+=2){let f=l[h],g=l[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Lm=new rc,tr=class{constructor(e){this.manager=e!==void 0?e:Lm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};tr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ki={},Fu=class extends Error{constructor(e,t){super(e),this.response=t}},xa=class extends tr{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Uu.get(`file:${e}`);if(r!==void 0)return this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0),r;if(Ki[e]!==void 0){Ki[e].push({onLoad:t,onProgress:n,onError:s});return}Ki[e]=[],Ki[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,c=this.responseType;fetch(o).then(l=>{if(l.status===200||l.status===0){if(l.status===0&&console.warn("THREE.FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||l.body===void 0||l.body.getReader===void 0)return l;let u=Ki[e],h=l.body.getReader(),d=l.headers.get("X-File-Size")||l.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,x=0,m=new ReadableStream({start(p){M();function M(){h.read().then(({done:S,value:v})=>{if(S)p.close();else{x+=v.byteLength;let P=new ProgressEvent("progress",{lengthComputable:g,loaded:x,total:f});for(let A=0,D=u.length;A<D;A++){let F=u[A];F.onProgress&&F.onProgress(P)}p.enqueue(v),M()}},S=>{p.error(S)})}}});return new Response(m)}else throw new Fu(`fetch for "${l.url}" responded with ${l.status}: ${l.statusText}`,l)}).then(l=>{switch(c){case"arraybuffer":return l.arrayBuffer();case"blob":return l.blob();case"document":return l.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return l.json();default:if(a==="")return l.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),d=h&&h[1]?h[1].toLowerCase():void 0,f=new TextDecoder(d);return l.arrayBuffer().then(g=>f.decode(g))}}}).then(l=>{Uu.add(`file:${e}`,l);let u=Ki[e];delete Ki[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onLoad&&f.onLoad(l)}}).catch(l=>{let u=Ki[e];if(u===void 0)throw this.manager.itemError(e),l;delete Ki[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onError&&f.onError(l)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var va=class extends bn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new tt(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},nr=class extends va{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(bn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new tt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},Tu=new Pt,Dp=new O,Np=new O,Ou=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new be(512,512),this.mapType=yi,this.map=null,this.mapPass=null,this.matrix=new Pt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Jr,this._frameExtents=new be(1,1),this._viewportCount=1,this._viewports=[new $t(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;Dp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Dp),Np.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Np),t.updateMatrixWorld(),Tu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Tu,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Tu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var ya=class extends Jo{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ku=class extends Ou{constructor(){super(new ya(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ir=class extends va{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(bn.DEFAULT_UP),this.updateMatrix(),this.target=new bn,this.shadow=new ku}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var oc=class extends gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var ld="\\[\\]\\.:\\/",uv=new RegExp("["+ld+"]","g"),cd="[^"+ld+"]",dv="[^"+ld.replace("\\.","")+"]",fv=/((?:WC+[\/:])*)/.source.replace("WC",cd),pv=/(WCOD+)?/.source.replace("WCOD",dv),mv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",cd),gv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",cd),_v=new RegExp("^"+fv+pv+mv+gv+"$"),xv=["material","materials","bones","map"],Bu=class{constructor(e,t,n){let s=n||Gt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Gt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(uv,"")}static parseTrackName(e){let t=_v.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);xv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===l){l=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Gt.Composite=Bu;Gt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Gt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Gt.prototype.GetterByBindingType=[Gt.prototype._getValue_direct,Gt.prototype._getValue_array,Gt.prototype._getValue_arrayElement,Gt.prototype._getValue_toArray];Gt.prototype.SetterByBindingTypeAndVersioning=[[Gt.prototype._setValue_direct,Gt.prototype._setValue_direct_setNeedsUpdate,Gt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_array,Gt.prototype._setValue_array_setNeedsUpdate,Gt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_arrayElement,Gt.prototype._setValue_arrayElement_setNeedsUpdate,Gt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_fromArray,Gt.prototype._setValue_fromArray_setNeedsUpdate,Gt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var H1=new Float32Array(1);var Up=new Pt,ba=class{constructor(e,t,n=0,s=1/0){this.ray=new Ms(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Zr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Up.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Up),this}intersectObject(e,t=!0,n=[]){return zu(e,this,n,t),n.sort(Fp),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)zu(e[s],this,n,t);return n.sort(Fp),n}};function Fp(i,e){return i.distance-e.distance}function zu(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)zu(r[o],e,t,!0)}}var to=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ot(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ot(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var sr=class extends Gl{constructor(e=10,t=10,n=4473924,s=8947848){n=new tt(n),s=new tt(s);let r=t/2,o=e/t,a=e/2,c=[],l=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){c.push(-a,0,g,a,0,g),c.push(g,0,-a,g,0,a);let x=d===r?n:s;x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3}let u=new Jt;u.setAttribute("position",new Tt(c,3)),u.setAttribute("color",new Tt(l,3));let h=new ws({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){this.geometry.dispose(),this.material.dispose()}};var Ma=class extends Ii{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function hd(i,e,t,n){let s=vv(n);switch(t){case Ju:return i*e;case Qu:return i*e/s.components*s.byteLength;case bc:return i*e/s.components*s.byteLength;case ed:return i*e*2/s.components*s.byteLength;case Mc:return i*e*2/s.components*s.byteLength;case ju:return i*e*3/s.components*s.byteLength;case ai:return i*e*4/s.components*s.byteLength;case Sc:return i*e*4/s.components*s.byteLength;case Ea:case Ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Aa:case Ca:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ec:case Ac:return Math.max(i,16)*Math.max(e,8)/4;case wc:case Tc:return Math.max(i,8)*Math.max(e,8)/2;case Cc:case Rc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Pc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ic:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Lc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Dc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Nc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Uc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Fc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Oc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case kc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Bc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case zc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Vc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Hc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Gc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Wc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Xc:case qc:case Yc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case $c:case Zc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Kc:case Jc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function vv(i){switch(i){case yi:case Yu:return{byteLength:1,components:1};case no:case $u:case io:return{byteLength:2,components:1};case vc:case yc:return{byteLength:2,components:4};case Is:case xc:case Oi:return{byteLength:4,components:1};case Zu:case Ku:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function ng(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function bv(i){let e=new WeakMap;function t(a,c){let l=a.array,u=a.usage,h=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,c,l){let u=c.array,h=c.updateRanges;if(i.bindBuffer(l,a),h.length===0)i.bufferSubData(l,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],x=h[f];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let x=h[f];i.bufferSubData(l,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Mv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Sv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,wv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ev=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Tv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Av=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Rv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Pv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Iv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Lv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Dv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Nv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Uv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Fv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ov=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,kv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Bv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Vv=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Hv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Gv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Wv=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,Xv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,qv=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,Yv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,$v=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Zv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Kv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,jv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Qv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ey=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,ty=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,ny=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,iy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,sy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ry=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,oy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ay=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ly=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,cy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,hy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,uy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,dy=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,fy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,py=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,my=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,gy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,_y=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,xy=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,vy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yy=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,by=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,My=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Sy=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,wy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ey=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ty=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ay=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Cy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ry=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Py=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Iy=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ly=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Dy=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ny=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Uy=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Fy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Oy=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ky=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,By=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,zy=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Vy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Wy=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Xy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Yy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$y=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Zy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ky=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,Jy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,jy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Qy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,eb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,nb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,ib=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,sb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,rb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ob=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ab=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,lb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,cb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,ub=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,db=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,pb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,mb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,gb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,_b=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,vb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,yb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Mb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wb=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Tb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ab=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Cb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Rb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Pb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Ib=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Lb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Db=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Nb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ub=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Fb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ob=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Bb=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,zb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Hb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Gb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Wb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Xb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,qb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Yb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$b=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Kb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Jb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Qb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,eM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,at={alphahash_fragment:Mv,alphahash_pars_fragment:Sv,alphamap_fragment:wv,alphamap_pars_fragment:Ev,alphatest_fragment:Tv,alphatest_pars_fragment:Av,aomap_fragment:Cv,aomap_pars_fragment:Rv,batching_pars_vertex:Pv,batching_vertex:Iv,begin_vertex:Lv,beginnormal_vertex:Dv,bsdfs:Nv,iridescence_fragment:Uv,bumpmap_pars_fragment:Fv,clipping_planes_fragment:Ov,clipping_planes_pars_fragment:kv,clipping_planes_pars_vertex:Bv,clipping_planes_vertex:zv,color_fragment:Vv,color_pars_fragment:Hv,color_pars_vertex:Gv,color_vertex:Wv,common:Xv,cube_uv_reflection_fragment:qv,defaultnormal_vertex:Yv,displacementmap_pars_vertex:$v,displacementmap_vertex:Zv,emissivemap_fragment:Kv,emissivemap_pars_fragment:Jv,colorspace_fragment:jv,colorspace_pars_fragment:Qv,envmap_fragment:ey,envmap_common_pars_fragment:ty,envmap_pars_fragment:ny,envmap_pars_vertex:iy,envmap_physical_pars_fragment:py,envmap_vertex:sy,fog_vertex:ry,fog_pars_vertex:oy,fog_fragment:ay,fog_pars_fragment:ly,gradientmap_pars_fragment:cy,lightmap_pars_fragment:hy,lights_lambert_fragment:uy,lights_lambert_pars_fragment:dy,lights_pars_begin:fy,lights_toon_fragment:my,lights_toon_pars_fragment:gy,lights_phong_fragment:_y,lights_phong_pars_fragment:xy,lights_physical_fragment:vy,lights_physical_pars_fragment:yy,lights_fragment_begin:by,lights_fragment_maps:My,lights_fragment_end:Sy,logdepthbuf_fragment:wy,logdepthbuf_pars_fragment:Ey,logdepthbuf_pars_vertex:Ty,logdepthbuf_vertex:Ay,map_fragment:Cy,map_pars_fragment:Ry,map_particle_fragment:Py,map_particle_pars_fragment:Iy,metalnessmap_fragment:Ly,metalnessmap_pars_fragment:Dy,morphinstance_vertex:Ny,morphcolor_vertex:Uy,morphnormal_vertex:Fy,morphtarget_pars_vertex:Oy,morphtarget_vertex:ky,normal_fragment_begin:By,normal_fragment_maps:zy,normal_pars_fragment:Vy,normal_pars_vertex:Hy,normal_vertex:Gy,normalmap_pars_fragment:Wy,clearcoat_normal_fragment_begin:Xy,clearcoat_normal_fragment_maps:qy,clearcoat_pars_fragment:Yy,iridescence_pars_fragment:$y,opaque_fragment:Zy,packing:Ky,premultiplied_alpha_fragment:Jy,project_vertex:jy,dithering_fragment:Qy,dithering_pars_fragment:eb,roughnessmap_fragment:tb,roughnessmap_pars_fragment:nb,shadowmap_pars_fragment:ib,shadowmap_pars_vertex:sb,shadowmap_vertex:rb,shadowmask_pars_fragment:ob,skinbase_vertex:ab,skinning_pars_vertex:lb,skinning_vertex:cb,skinnormal_vertex:hb,specularmap_fragment:ub,specularmap_pars_fragment:db,tonemapping_fragment:fb,tonemapping_pars_fragment:pb,transmission_fragment:mb,transmission_pars_fragment:gb,uv_pars_fragment:_b,uv_pars_vertex:xb,uv_vertex:vb,worldpos_vertex:yb,background_vert:bb,background_frag:Mb,backgroundCube_vert:Sb,backgroundCube_frag:wb,cube_vert:Eb,cube_frag:Tb,depth_vert:Ab,depth_frag:Cb,distanceRGBA_vert:Rb,distanceRGBA_frag:Pb,equirect_vert:Ib,equirect_frag:Lb,linedashed_vert:Db,linedashed_frag:Nb,meshbasic_vert:Ub,meshbasic_frag:Fb,meshlambert_vert:Ob,meshlambert_frag:kb,meshmatcap_vert:Bb,meshmatcap_frag:zb,meshnormal_vert:Vb,meshnormal_frag:Hb,meshphong_vert:Gb,meshphong_frag:Wb,meshphysical_vert:Xb,meshphysical_frag:qb,meshtoon_vert:Yb,meshtoon_frag:$b,points_vert:Zb,points_frag:Kb,shadow_vert:Jb,shadow_frag:jb,sprite_vert:Qb,sprite_frag:eM},we={common:{diffuse:{value:new tt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new be(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new tt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new tt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new tt(16777215)},opacity:{value:1},center:{value:new be(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},ki={basic:{uniforms:Tn([we.common,we.specularmap,we.envmap,we.aomap,we.lightmap,we.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:Tn([we.common,we.specularmap,we.envmap,we.aomap,we.lightmap,we.emissivemap,we.bumpmap,we.normalmap,we.displacementmap,we.fog,we.lights,{emissive:{value:new tt(0)}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:Tn([we.common,we.specularmap,we.envmap,we.aomap,we.lightmap,we.emissivemap,we.bumpmap,we.normalmap,we.displacementmap,we.fog,we.lights,{emissive:{value:new tt(0)},specular:{value:new tt(1118481)},shininess:{value:30}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:Tn([we.common,we.envmap,we.aomap,we.lightmap,we.emissivemap,we.bumpmap,we.normalmap,we.displacementmap,we.roughnessmap,we.metalnessmap,we.fog,we.lights,{emissive:{value:new tt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:Tn([we.common,we.aomap,we.lightmap,we.emissivemap,we.bumpmap,we.normalmap,we.displacementmap,we.gradientmap,we.fog,we.lights,{emissive:{value:new tt(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:Tn([we.common,we.bumpmap,we.normalmap,we.displacementmap,we.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:Tn([we.points,we.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:Tn([we.common,we.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:Tn([we.common,we.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:Tn([we.common,we.bumpmap,we.normalmap,we.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:Tn([we.sprite,we.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distanceRGBA:{uniforms:Tn([we.common,we.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distanceRGBA_vert,fragmentShader:at.distanceRGBA_frag},shadow:{uniforms:Tn([we.lights,we.fog,{color:{value:new tt(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};ki.physical={uniforms:Tn([ki.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new be(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new tt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new be},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new tt(0)},specularColor:{value:new tt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new be},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};var jc={r:0,b:0,g:0},cr=new Yn,tM=new Pt;function nM(i,e,t,n,s,r,o){let a=new tt(0),c=r===!0?0:1,l,u,h=null,d=0,f=null;function g(S){let v=S.isScene===!0?S.background:null;return v&&v.isTexture&&(v=(S.backgroundBlurriness>0?t:e).get(v)),v}function x(S){let v=!1,P=g(S);P===null?p(a,c):P&&P.isColor&&(p(P,1),v=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?n.buffers.color.setClear(0,0,0,1,o):A==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||v)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(S,v){let P=g(v);P&&(P.isCubeTexture||P.mapping===Sa)?(u===void 0&&(u=new Wt(new Ss(1,1,1),new vi({name:"BackgroundCubeMaterial",uniforms:lr(ki.backgroundCube.uniforms),vertexShader:ki.backgroundCube.vertexShader,fragmentShader:ki.backgroundCube.fragmentShader,side:Un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(A,D,F){this.matrixWorld.copyPosition(F.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),cr.copy(v.backgroundRotation),cr.x*=-1,cr.y*=-1,cr.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(cr.y*=-1,cr.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=v.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(tM.makeRotationFromEuler(cr)),u.material.toneMapped=ft.getTransfer(P.colorSpace)!==Et,(h!==P||d!==P.version||f!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,d=P.version,f=i.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(l===void 0&&(l=new Wt(new fa(2,2),new vi({name:"BackgroundMaterial",uniforms:lr(ki.background.uniforms),vertexShader:ki.background.vertexShader,fragmentShader:ki.background.fragmentShader,side:ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(l)),l.material.uniforms.t2D.value=P,l.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,l.material.toneMapped=ft.getTransfer(P.colorSpace)!==Et,P.matrixAutoUpdate===!0&&P.updateMatrix(),l.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||d!==P.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=P,d=P.version,f=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function p(S,v){S.getRGB(jc,od(i)),n.buffers.color.setClear(jc.r,jc.g,jc.b,v,o)}function M(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,v=1){a.set(S),c=v,p(a,c)},getClearAlpha:function(){return c},setClearAlpha:function(S){c=S,p(a,c)},render:x,addToRenderList:m,dispose:M}}function iM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(w,C,k,V,W){let X=!1,q=h(V,k,C);r!==q&&(r=q,l(r.object)),X=f(w,V,k,W),X&&g(w,V,k,W),W!==null&&e.update(W,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,v(w,C,k,V),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function c(){return i.createVertexArray()}function l(w){return i.bindVertexArray(w)}function u(w){return i.deleteVertexArray(w)}function h(w,C,k){let V=k.wireframe===!0,W=n[w.id];W===void 0&&(W={},n[w.id]=W);let X=W[C.id];X===void 0&&(X={},W[C.id]=X);let q=X[V];return q===void 0&&(q=d(c()),X[V]=q),q}function d(w){let C=[],k=[],V=[];for(let W=0;W<t;W++)C[W]=0,k[W]=0,V[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:k,attributeDivisors:V,object:w,attributes:{},index:null}}function f(w,C,k,V){let W=r.attributes,X=C.attributes,q=0,j=k.getAttributes();for(let $ in j)if(j[$].location>=0){let le=W[$],xe=X[$];if(xe===void 0&&($==="instanceMatrix"&&w.instanceMatrix&&(xe=w.instanceMatrix),$==="instanceColor"&&w.instanceColor&&(xe=w.instanceColor)),le===void 0||le.attribute!==xe||xe&&le.data!==xe.data)return!0;q++}return r.attributesNum!==q||r.index!==V}function g(w,C,k,V){let W={},X=C.attributes,q=0,j=k.getAttributes();for(let $ in j)if(j[$].location>=0){let le=X[$];le===void 0&&($==="instanceMatrix"&&w.instanceMatrix&&(le=w.instanceMatrix),$==="instanceColor"&&w.instanceColor&&(le=w.instanceColor));let xe={};xe.attribute=le,le&&le.data&&(xe.data=le.data),W[$]=xe,q++}r.attributes=W,r.attributesNum=q,r.index=V}function x(){let w=r.newAttributes;for(let C=0,k=w.length;C<k;C++)w[C]=0}function m(w){p(w,0)}function p(w,C){let k=r.newAttributes,V=r.enabledAttributes,W=r.attributeDivisors;k[w]=1,V[w]===0&&(i.enableVertexAttribArray(w),V[w]=1),W[w]!==C&&(i.vertexAttribDivisor(w,C),W[w]=C)}function M(){let w=r.newAttributes,C=r.enabledAttributes;for(let k=0,V=C.length;k<V;k++)C[k]!==w[k]&&(i.disableVertexAttribArray(k),C[k]=0)}function S(w,C,k,V,W,X,q){q===!0?i.vertexAttribIPointer(w,C,k,W,X):i.vertexAttribPointer(w,C,k,V,W,X)}function v(w,C,k,V){x();let W=V.attributes,X=k.getAttributes(),q=C.defaultAttributeValues;for(let j in X){let $=X[j];if($.location>=0){let ae=W[j];if(ae===void 0&&(j==="instanceMatrix"&&w.instanceMatrix&&(ae=w.instanceMatrix),j==="instanceColor"&&w.instanceColor&&(ae=w.instanceColor)),ae!==void 0){let le=ae.normalized,xe=ae.itemSize,Me=e.get(ae);if(Me===void 0)continue;let _e=Me.buffer,nt=Me.type,Je=Me.bytesPerElement,Q=nt===i.INT||nt===i.UNSIGNED_INT||ae.gpuType===xc;if(ae.isInterleavedBufferAttribute){let ne=ae.data,Ee=ne.stride,ze=ae.offset;if(ne.isInstancedInterleavedBuffer){for(let ve=0;ve<$.locationSize;ve++)p($.location+ve,ne.meshPerAttribute);w.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let ve=0;ve<$.locationSize;ve++)m($.location+ve);i.bindBuffer(i.ARRAY_BUFFER,_e);for(let ve=0;ve<$.locationSize;ve++)S($.location+ve,xe/$.locationSize,nt,le,Ee*Je,(ze+xe/$.locationSize*ve)*Je,Q)}else{if(ae.isInstancedBufferAttribute){for(let ne=0;ne<$.locationSize;ne++)p($.location+ne,ae.meshPerAttribute);w.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let ne=0;ne<$.locationSize;ne++)m($.location+ne);i.bindBuffer(i.ARRAY_BUFFER,_e);for(let ne=0;ne<$.locationSize;ne++)S($.location+ne,xe/$.locationSize,nt,le,xe*Je,xe/$.locationSize*ne*Je,Q)}}else if(q!==void 0){let le=q[j];if(le!==void 0)switch(le.length){case 2:i.vertexAttrib2fv($.location,le);break;case 3:i.vertexAttrib3fv($.location,le);break;case 4:i.vertexAttrib4fv($.location,le);break;default:i.vertexAttrib1fv($.location,le)}}}}M()}function P(){F();for(let w in n){let C=n[w];for(let k in C){let V=C[k];for(let W in V)u(V[W].object),delete V[W];delete C[k]}delete n[w]}}function A(w){if(n[w.id]===void 0)return;let C=n[w.id];for(let k in C){let V=C[k];for(let W in V)u(V[W].object),delete V[W];delete C[k]}delete n[w.id]}function D(w){for(let C in n){let k=n[C];if(k[w.id]===void 0)continue;let V=k[w.id];for(let W in V)u(V[W].object),delete V[W];delete k[w.id]}}function F(){T(),o=!0,r!==s&&(r=s,l(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:T,dispose:P,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:x,enableAttribute:m,disableUnusedAttributes:M}}function sM(i,e,t){let n;function s(l){n=l}function r(l,u){i.drawArrays(n,l,u),t.update(u,n,1)}function o(l,u,h){h!==0&&(i.drawArraysInstanced(n,l,u,h),t.update(u,n,h))}function a(l,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,u,0,h);let f=0;for(let g=0;g<h;g++)f+=u[g];t.update(f,n,1)}function c(l,u,h,d){if(h===0)return;let f=e.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<l.length;g++)o(l[g],u[g],d[g]);else{f.multiDrawArraysInstancedWEBGL(n,l,0,u,0,d,0,h);let g=0;for(let x=0;x<h;x++)g+=u[x]*d[x];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=c}function rM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let D=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ai&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let F=D===io&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==yi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Oi&&!F)}function c(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",u=c(l);u!==l&&(console.warn("THREE.WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=g>0,A=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:v,vertexTextures:P,maxSamples:A}}function oM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ri,a=new st,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):l();else{let M=r?0:n,S=M*4,v=p.clippingState||null;c.value=v,v=u(g,d,S,f);for(let P=0;P!==S;++P)v[P]=t[P];p.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,g){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=c.value,g!==!0||m===null){let p=f+x*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<p)&&(m=new Float32Array(p));for(let S=0,v=f;S!==x;++S,v+=4)o.copy(h[S]).applyMatrix4(M,a),o.normal.toArray(m,v),m[v+3]=o.constant}c.value=m,c.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}function aM(i){let e=new WeakMap;function t(o,a){return a===mc?o.mapping=rr:a===gc&&(o.mapping=or),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===mc||a===gc)if(e.has(o)){let c=e.get(o).texture;return t(c,o.mapping)}else{let c=o.image;if(c&&c.height>0){let l=new zl(c.height);return l.fromEquirectangularTexture(i,o),e.set(o,l),o.addEventListener("dispose",s),t(l.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let c=e.get(a);c!==void 0&&(e.delete(a),c.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var ao=4,Dm=[.125,.215,.35,.446,.526,.582],dr=20,ud=new ya,Nm=new tt,dd=null,fd=0,pd=0,md=!1,ur=(1+Math.sqrt(5))/2,oo=1/ur,Um=[new O(-ur,oo,0),new O(ur,oo,0),new O(-oo,0,ur),new O(oo,0,ur),new O(0,ur,-oo),new O(0,ur,oo),new O(-1,1,-1),new O(1,1,-1),new O(-1,1,1),new O(1,1,1)],lM=new O,th=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=lM}=r;dd=this._renderer.getRenderTarget(),fd=this._renderer.getActiveCubeFace(),pd=this._renderer.getActiveMipmapLevel(),md=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let c=this._allocateTargets();return c.depthBuffer=!0,this._sceneToCubeUV(e,n,s,c,a),t>0&&this._blur(c,0,0,t),this._applyPMREM(c),this._cleanup(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=km(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Om(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(dd,fd,pd),this._renderer.xr.enabled=md,e.scissorTest=!1,Qc(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===rr||e.mapping===or?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),dd=this._renderer.getRenderTarget(),fd=this._renderer.getActiveCubeFace(),pd=this._renderer.getActiveMipmapLevel(),md=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:xi,minFilter:xi,generateMipmaps:!1,type:io,format:ai,colorSpace:Zs,depthBuffer:!1},s=Fm(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Fm(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=cM(r)),this._blurMaterial=hM(r,e,t)}return s}_compileMaterial(e){let t=new Wt(this._lodPlanes[0],e);this._renderer.compile(t,ud)}_sceneToCubeUV(e,t,n,s,r){let c=new gn(90,1,t,n),l=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,d=h.autoClear,f=h.toneMapping;h.getClearColor(Nm),h.toneMapping=ts,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let x=new Ni({name:"PMREM.Background",side:Un,depthWrite:!1,depthTest:!1}),m=new Wt(new Ss,x),p=!1,M=e.background;M?M.isColor&&(x.color.copy(M),e.background=null,p=!0):(x.color.copy(Nm),p=!0);for(let S=0;S<6;S++){let v=S%3;v===0?(c.up.set(0,l[S],0),c.position.set(r.x,r.y,r.z),c.lookAt(r.x+u[S],r.y,r.z)):v===1?(c.up.set(0,0,l[S]),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y+u[S],r.z)):(c.up.set(0,l[S],0),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y,r.z+u[S]));let P=this._cubeSize;Qc(s,v*P,S>2?P:0,P,P),h.setRenderTarget(s),p&&h.render(m,c),h.render(e,c)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=f,h.autoClear=d,e.background=M}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===rr||e.mapping===or;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=km()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Om());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Wt(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let c=this._cubeSize;Qc(t,0,0,3*c,2*c),n.setRenderTarget(t),n.render(o,ud)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Um[(s-r-1)%Um.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let c=this._renderer,l=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Wt(this._lodPlanes[s],l),d=l.uniforms,f=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*dr-1),x=r/g,m=isFinite(r)?1+Math.floor(u*x):dr;m>dr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${dr}`);let p=[],M=0;for(let D=0;D<dr;++D){let F=D/x,T=Math.exp(-F*F/2);p.push(T),D===0?M+=T:D<m&&(M+=2*T)}for(let D=0;D<p.length;D++)p[D]=p[D]/M;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);let{_lodMax:S}=this;d.dTheta.value=g,d.mipInt.value=S-n;let v=this._sizeLods[s],P=3*v*(s>S-ao?s-S+ao:0),A=4*(this._cubeSize-v);Qc(t,P,A,3*v,2*v),c.setRenderTarget(t),c.render(h,ud)}};function cM(i){let e=[],t=[],n=[],s=i,r=i-ao+1+Dm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let c=1/a;o>i-ao?c=Dm[o-i+ao-1]:o===0&&(c=0),n.push(c);let l=1/(a-2),u=-l,h=1+l,d=[u,u,h,u,h,h,u,u,h,h,u,h],f=6,g=6,x=3,m=2,p=1,M=new Float32Array(x*g*f),S=new Float32Array(m*g*f),v=new Float32Array(p*g*f);for(let A=0;A<f;A++){let D=A%3*2/3-1,F=A>2?0:-1,T=[D,F,0,D+2/3,F,0,D+2/3,F+1,0,D,F,0,D+2/3,F+1,0,D,F+1,0];M.set(T,x*g*A),S.set(d,m*g*A);let w=[A,A,A,A,A,A];v.set(w,p*g*A)}let P=new Jt;P.setAttribute("position",new nn(M,x)),P.setAttribute("uv",new nn(S,m)),P.setAttribute("faceIndex",new nn(v,p)),e.push(P),s>ao&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function Fm(i,e,t){let n=new Li(i,e,t);return n.texture.mapping=Sa,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Qc(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function hM(i,e,t){let n=new Float32Array(dr),s=new O(0,1,0);return new vi({name:"SphericalGaussianBlur",defines:{n:dr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Ed(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function Om(){return new vi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Ed(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function km(){return new vi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Ed(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:es,depthTest:!1,depthWrite:!1})}function Ed(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function uM(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let c=a.mapping,l=c===mc||c===gc,u=c===rr||c===or;if(l||u){let h=e.get(a),d=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new th(i)),h=l?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let f=a.image;return l&&f&&f.height>0||u&&f&&s(f)?(t===null&&(t=new th(i)),h=l?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let c=0,l=6;for(let u=0;u<l;u++)a[u]!==void 0&&c++;return c===l}function r(a){let c=a.target;c.removeEventListener("dispose",r);let l=e.get(c);l!==void 0&&(e.delete(c),l.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function dM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Yr("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function fM(i,e,t,n){let s={},r=new WeakMap;function o(h){let d=h.target;d.index!==null&&e.remove(d.index);for(let g in d.attributes)e.remove(d.attributes[g]);d.removeEventListener("dispose",o),delete s[d.id];let f=r.get(d);f&&(e.remove(f),r.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(h,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function c(h){let d=h.attributes;for(let f in d)e.update(d[f],i.ARRAY_BUFFER)}function l(h){let d=[],f=h.index,g=h.attributes.position,x=0;if(f!==null){let M=f.array;x=f.version;for(let S=0,v=M.length;S<v;S+=3){let P=M[S+0],A=M[S+1],D=M[S+2];d.push(P,A,A,D,D,P)}}else if(g!==void 0){let M=g.array;x=g.version;for(let S=0,v=M.length/3-1;S<v;S+=3){let P=S+0,A=S+1,D=S+2;d.push(P,A,A,D,D,P)}}else return;let m=new(rd(d)?Ko:Zo)(d,1);m.version=x;let p=r.get(h);p&&e.remove(p),r.set(h,m)}function u(h){let d=r.get(h);if(d){let f=h.index;f!==null&&d.version<f.version&&l(h)}else l(h);return r.get(h)}return{get:a,update:c,getWireframeAttribute:u}}function pM(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,f){i.drawElements(n,f,r,d*o),t.update(f,n,1)}function l(d,f,g){g!==0&&(i.drawElementsInstanced(n,f,r,d*o,g),t.update(f,n,g))}function u(d,f,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,d,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];t.update(m,n,1)}function h(d,f,g,x){if(g===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)l(d[p]/o,f[p],x[p]);else{m.multiDrawElementsInstancedWEBGL(n,f,0,r,d,0,x,0,g);let p=0;for(let M=0;M<g;M++)p+=f[M]*x[M];t.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function mM(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function gM(i,e,t){let n=new WeakMap,s=new $t;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let T=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],S=0;f===!0&&(S=1),g===!0&&(S=2),x===!0&&(S=3);let v=a.attributes.position.count*S,P=1;v>e.maxTextureSize&&(P=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let A=new Float32Array(v*P*4*h),D=new $o(A,v,P,h);D.type=Oi,D.needsUpdate=!0;let F=S*4;for(let w=0;w<h;w++){let C=m[w],k=p[w],V=M[w],W=v*P*4*w;for(let X=0;X<C.count;X++){let q=X*F;f===!0&&(s.fromBufferAttribute(C,X),A[W+q+0]=s.x,A[W+q+1]=s.y,A[W+q+2]=s.z,A[W+q+3]=0),g===!0&&(s.fromBufferAttribute(k,X),A[W+q+4]=s.x,A[W+q+5]=s.y,A[W+q+6]=s.z,A[W+q+7]=0),x===!0&&(s.fromBufferAttribute(V,X),A[W+q+8]=s.x,A[W+q+9]=s.y,A[W+q+10]=s.z,A[W+q+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:D,size:new be(v,P)},n.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<l.length;x++)f+=l[x];let g=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function _M(i,e,t,n){let s=new WeakMap;function r(c){let l=n.render.frame,u=c.geometry,h=e.get(c,u);if(s.get(h)!==l&&(e.update(h),s.set(h,l)),c.isInstancedMesh&&(c.hasEventListener("dispose",a)===!1&&c.addEventListener("dispose",a),s.get(c)!==l&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,l))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==l&&(d.update(),s.set(d,l))}return h}function o(){s=new WeakMap}function a(c){let l=c.target;l.removeEventListener("dispose",a),t.remove(l.instanceMatrix),l.instanceColor!==null&&t.remove(l.instanceColor)}return{update:r,dispose:o}}var ig=new qn,Bm=new ta(1,1),sg=new $o,rg=new kl,og=new jo,zm=[],Vm=[],Hm=new Float32Array(16),Gm=new Float32Array(9),Wm=new Float32Array(4);function ho(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=zm[s];if(r===void 0&&(r=new Float32Array(s),zm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function sn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function rn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function nh(i,e){let t=Vm[e];t===void 0&&(t=new Int32Array(e),Vm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function xM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function vM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(sn(t,e))return;i.uniform2fv(this.addr,e),rn(t,e)}}function yM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(sn(t,e))return;i.uniform3fv(this.addr,e),rn(t,e)}}function bM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(sn(t,e))return;i.uniform4fv(this.addr,e),rn(t,e)}}function MM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(sn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),rn(t,e)}else{if(sn(t,n))return;Wm.set(n),i.uniformMatrix2fv(this.addr,!1,Wm),rn(t,n)}}function SM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(sn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),rn(t,e)}else{if(sn(t,n))return;Gm.set(n),i.uniformMatrix3fv(this.addr,!1,Gm),rn(t,n)}}function wM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(sn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),rn(t,e)}else{if(sn(t,n))return;Hm.set(n),i.uniformMatrix4fv(this.addr,!1,Hm),rn(t,n)}}function EM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function TM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(sn(t,e))return;i.uniform2iv(this.addr,e),rn(t,e)}}function AM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(sn(t,e))return;i.uniform3iv(this.addr,e),rn(t,e)}}function CM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(sn(t,e))return;i.uniform4iv(this.addr,e),rn(t,e)}}function RM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function PM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(sn(t,e))return;i.uniform2uiv(this.addr,e),rn(t,e)}}function IM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(sn(t,e))return;i.uniform3uiv(this.addr,e),rn(t,e)}}function LM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(sn(t,e))return;i.uniform4uiv(this.addr,e),rn(t,e)}}function DM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Bm.compareFunction=nd,r=Bm):r=ig,t.setTexture2D(e||r,s)}function NM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||rg,s)}function UM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||og,s)}function FM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||sg,s)}function OM(i){switch(i){case 5126:return xM;case 35664:return vM;case 35665:return yM;case 35666:return bM;case 35674:return MM;case 35675:return SM;case 35676:return wM;case 5124:case 35670:return EM;case 35667:case 35671:return TM;case 35668:case 35672:return AM;case 35669:case 35673:return CM;case 5125:return RM;case 36294:return PM;case 36295:return IM;case 36296:return LM;case 35678:case 36198:case 36298:case 36306:case 35682:return DM;case 35679:case 36299:case 36307:return NM;case 35680:case 36300:case 36308:case 36293:return UM;case 36289:case 36303:case 36311:case 36292:return FM}}function kM(i,e){i.uniform1fv(this.addr,e)}function BM(i,e){let t=ho(e,this.size,2);i.uniform2fv(this.addr,t)}function zM(i,e){let t=ho(e,this.size,3);i.uniform3fv(this.addr,t)}function VM(i,e){let t=ho(e,this.size,4);i.uniform4fv(this.addr,t)}function HM(i,e){let t=ho(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function GM(i,e){let t=ho(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function WM(i,e){let t=ho(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function XM(i,e){i.uniform1iv(this.addr,e)}function qM(i,e){i.uniform2iv(this.addr,e)}function YM(i,e){i.uniform3iv(this.addr,e)}function $M(i,e){i.uniform4iv(this.addr,e)}function ZM(i,e){i.uniform1uiv(this.addr,e)}function KM(i,e){i.uniform2uiv(this.addr,e)}function JM(i,e){i.uniform3uiv(this.addr,e)}function jM(i,e){i.uniform4uiv(this.addr,e)}function QM(i,e,t){let n=this.cache,s=e.length,r=nh(t,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||ig,r[o])}function eS(i,e,t){let n=this.cache,s=e.length,r=nh(t,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||rg,r[o])}function tS(i,e,t){let n=this.cache,s=e.length,r=nh(t,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||og,r[o])}function nS(i,e,t){let n=this.cache,s=e.length,r=nh(t,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||sg,r[o])}function iS(i){switch(i){case 5126:return kM;case 35664:return BM;case 35665:return zM;case 35666:return VM;case 35674:return HM;case 35675:return GM;case 35676:return WM;case 5124:case 35670:return XM;case 35667:case 35671:return qM;case 35668:case 35672:return YM;case 35669:case 35673:return $M;case 5125:return ZM;case 36294:return KM;case 36295:return JM;case 36296:return jM;case 35678:case 36198:case 36298:case 36306:case 35682:return QM;case 35679:case 36299:case 36307:return eS;case 35680:case 36300:case 36308:case 36293:return tS;case 36289:case 36303:case 36311:case 36292:return nS}}var _d=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=OM(t.type)}},xd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=iS(t.type)}},vd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},gd=/(\w+)(\])?(\[|\.)?/g;function Xm(i,e){i.seq.push(e),i.map[e.id]=e}function sS(i,e,t){let n=i.name,s=n.length;for(gd.lastIndex=0;;){let r=gd.exec(n),o=gd.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Xm(t,l===void 0?new _d(a,i,e):new xd(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new vd(a),Xm(t,h)),t=h}}}var lo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);sS(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function qm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var rS=37297,oS=0;function aS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Ym=new st;function lS(i){ft._getMatrix(Ym,ft.workingColorSpace,i);let e=`mat3( ${Ym.elements.map(t=>t.toFixed(4))} )`;switch(ft.getTransfer(i)){case Xo:return[e,"LinearTransferOETF"];case Et:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function $m(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+aS(i.getShaderSource(e),a)}else return r}function cS(i,e){let t=lS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function hS(i,e){let t;switch(e){case om:t="Linear";break;case am:t="Reinhard";break;case lm:t="Cineon";break;case cm:t="ACESFilmic";break;case um:t="AgX";break;case dm:t="Neutral";break;case hm:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var eh=new O;function uS(){ft.getLuminanceCoefficients(eh);let i=eh.x.toFixed(4),e=eh.y.toFixed(4),t=eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Pa).join(`
`)}function fS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function pS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Pa(i){return i!==""}function Zm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Km(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var mS=/^[ \t]*#include +<([\w\d./]+)>/gm;function yd(i){return i.replace(mS,_S)}var gS=new Map;function _S(i,e){let t=at[e];if(t===void 0){let n=gS.get(e);if(n!==void 0)t=at[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return yd(t)}var xS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Jm(i){return i.replace(xS,vS)}function vS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function jm(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function yS(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Hu?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Bp?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ui&&(e="SHADOWMAP_TYPE_VSM"),e}function bS(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case rr:case or:e="ENVMAP_TYPE_CUBE";break;case Sa:e="ENVMAP_TYPE_CUBE_UV";break}return e}function MS(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case or:e="ENVMAP_MODE_REFRACTION";break}return e}function SS(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case pc:e="ENVMAP_BLENDING_MULTIPLY";break;case sm:e="ENVMAP_BLENDING_MIX";break;case rm:e="ENVMAP_BLENDING_ADD";break}return e}function wS(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function ES(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=yS(t),l=bS(t),u=MS(t),h=SS(t),d=wS(t),f=dS(t),g=fS(r),x=s.createProgram(),m,p,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Pa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Pa).join(`
`),p.length>0&&(p+=`
`)):(m=[jm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Pa).join(`
`),p=[jm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?at.tonemapping_pars_fragment:"",t.toneMapping!==ts?hS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,cS("linearToOutputTexel",t.outputColorSpace),uS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Pa).join(`
`)),o=yd(o),o=Zm(o,t),o=Km(o,t),a=yd(a),a=Zm(a,t),a=Km(a,t),o=Jm(o),a=Jm(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===id?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===id?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=M+m+o,v=M+p+a,P=qm(s,s.VERTEX_SHADER,S),A=qm(s,s.FRAGMENT_SHADER,v);s.attachShader(x,P),s.attachShader(x,A),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function D(C){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(x)||"",V=s.getShaderInfoLog(P)||"",W=s.getShaderInfoLog(A)||"",X=k.trim(),q=V.trim(),j=W.trim(),$=!0,ae=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,x,P,A);else{let le=$m(s,P,"vertex"),xe=$m(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+X+`
`+le+`
`+xe)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(q===""||j==="")&&(ae=!1);ae&&(C.diagnostics={runnable:$,programLog:X,vertexShader:{log:q,prefix:m},fragmentShader:{log:j,prefix:p}})}s.deleteShader(P),s.deleteShader(A),F=new lo(s,x),T=pS(s,x)}let F;this.getUniforms=function(){return F===void 0&&D(this),F};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let w=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return w===!1&&(w=s.getProgramParameter(x,rS)),w},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=oS++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=P,this.fragmentShader=A,this}var TS=0,bd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Md(e),t.set(e,n)),n}},Md=class{constructor(e){this.id=TS++,this.code=e,this.usedTimes=0}};function AS(i,e,t,n,s,r,o){let a=new Zr,c=new bd,l=new Set,u=[],h=s.logarithmicDepthBuffer,d=s.vertexTextures,f=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(T){return l.add(T),T===0?"uv":`uv${T}`}function m(T,w,C,k,V){let W=k.fog,X=V.geometry,q=T.isMeshStandardMaterial?k.environment:null,j=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),$=j&&j.mapping===Sa?j.image.height:null,ae=g[T.type];T.precision!==null&&(f=s.getMaxPrecision(T.precision),f!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",f,"instead."));let le=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,xe=le!==void 0?le.length:0,Me=0;X.morphAttributes.position!==void 0&&(Me=1),X.morphAttributes.normal!==void 0&&(Me=2),X.morphAttributes.color!==void 0&&(Me=3);let _e,nt,Je,Q;if(ae){let pt=ki[ae];_e=pt.vertexShader,nt=pt.fragmentShader}else _e=T.vertexShader,nt=T.fragmentShader,c.update(T),Je=c.getVertexShaderID(T),Q=c.getFragmentShaderID(T);let ne=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),ze=V.isInstancedMesh===!0,ve=V.isBatchedMesh===!0,je=!!T.map,Ut=!!T.matcap,N=!!j,dt=!!T.aoMap,$e=!!T.lightMap,We=!!T.bumpMap,Ue=!!T.normalMap,St=!!T.displacementMap,Pe=!!T.emissiveMap,Ge=!!T.metalnessMap,Bt=!!T.roughnessMap,vt=T.anisotropy>0,I=T.clearcoat>0,y=T.dispersion>0,U=T.iridescence>0,K=T.sheen>0,ie=T.transmission>0,te=vt&&!!T.anisotropyMap,Fe=I&&!!T.clearcoatMap,ue=I&&!!T.clearcoatNormalMap,Le=I&&!!T.clearcoatRoughnessMap,Ce=U&&!!T.iridescenceMap,oe=U&&!!T.iridescenceThicknessMap,ge=K&&!!T.sheenColorMap,Be=K&&!!T.sheenRoughnessMap,ke=!!T.specularMap,ye=!!T.specularColorMap,Ke=!!T.specularIntensityMap,B=ie&&!!T.transmissionMap,de=ie&&!!T.thicknessMap,pe=!!T.gradientMap,Ie=!!T.alphaMap,he=T.alphaTest>0,re=!!T.alphaHash,Oe=!!T.extensions,Qe=ts;T.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(Qe=i.toneMapping);let At={shaderID:ae,shaderType:T.type,shaderName:T.name,vertexShader:_e,fragmentShader:nt,defines:T.defines,customVertexShaderID:Je,customFragmentShaderID:Q,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:f,batching:ve,batchingColor:ve&&V._colorsTexture!==null,instancing:ze,instancingColor:ze&&V.instanceColor!==null,instancingMorph:ze&&V.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ne===null?i.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:Zs,alphaToCoverage:!!T.alphaToCoverage,map:je,matcap:Ut,envMap:N,envMapMode:N&&j.mapping,envMapCubeUVHeight:$,aoMap:dt,lightMap:$e,bumpMap:We,normalMap:Ue,displacementMap:d&&St,emissiveMap:Pe,normalMapObjectSpace:Ue&&T.normalMapType===gm,normalMapTangentSpace:Ue&&T.normalMapType===td,metalnessMap:Ge,roughnessMap:Bt,anisotropy:vt,anisotropyMap:te,clearcoat:I,clearcoatMap:Fe,clearcoatNormalMap:ue,clearcoatRoughnessMap:Le,dispersion:y,iridescence:U,iridescenceMap:Ce,iridescenceThicknessMap:oe,sheen:K,sheenColorMap:ge,sheenRoughnessMap:Be,specularMap:ke,specularColorMap:ye,specularIntensityMap:Ke,transmission:ie,transmissionMap:B,thicknessMap:de,gradientMap:pe,opaque:T.transparent===!1&&T.blending===Ys&&T.alphaToCoverage===!1,alphaMap:Ie,alphaTest:he,alphaHash:re,combine:T.combine,mapUv:je&&x(T.map.channel),aoMapUv:dt&&x(T.aoMap.channel),lightMapUv:$e&&x(T.lightMap.channel),bumpMapUv:We&&x(T.bumpMap.channel),normalMapUv:Ue&&x(T.normalMap.channel),displacementMapUv:St&&x(T.displacementMap.channel),emissiveMapUv:Pe&&x(T.emissiveMap.channel),metalnessMapUv:Ge&&x(T.metalnessMap.channel),roughnessMapUv:Bt&&x(T.roughnessMap.channel),anisotropyMapUv:te&&x(T.anisotropyMap.channel),clearcoatMapUv:Fe&&x(T.clearcoatMap.channel),clearcoatNormalMapUv:ue&&x(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Le&&x(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Ce&&x(T.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&x(T.iridescenceThicknessMap.channel),sheenColorMapUv:ge&&x(T.sheenColorMap.channel),sheenRoughnessMapUv:Be&&x(T.sheenRoughnessMap.channel),specularMapUv:ke&&x(T.specularMap.channel),specularColorMapUv:ye&&x(T.specularColorMap.channel),specularIntensityMapUv:Ke&&x(T.specularIntensityMap.channel),transmissionMapUv:B&&x(T.transmissionMap.channel),thicknessMapUv:de&&x(T.thicknessMap.channel),alphaMapUv:Ie&&x(T.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(Ue||vt),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!X.attributes.uv&&(je||Ie),fog:!!W,useFog:T.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Ee,skinning:V.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:xe,morphTextureStride:Me,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Qe,decodeVideoTexture:je&&T.map.isVideoTexture===!0&&ft.getTransfer(T.map.colorSpace)===Et,decodeVideoTextureEmissive:Pe&&T.emissiveMap.isVideoTexture===!0&&ft.getTransfer(T.emissiveMap.colorSpace)===Et,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Fi,flipSided:T.side===Un,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Oe&&T.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&T.extensions.multiDraw===!0||ve)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return At.vertexUv1s=l.has(1),At.vertexUv2s=l.has(2),At.vertexUv3s=l.has(3),l.clear(),At}function p(T){let w=[];if(T.shaderID?w.push(T.shaderID):(w.push(T.customVertexShaderID),w.push(T.customFragmentShaderID)),T.defines!==void 0)for(let C in T.defines)w.push(C),w.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(M(w,T),S(w,T),w.push(i.outputColorSpace)),w.push(T.customProgramCacheKey),w.join()}function M(T,w){T.push(w.precision),T.push(w.outputColorSpace),T.push(w.envMapMode),T.push(w.envMapCubeUVHeight),T.push(w.mapUv),T.push(w.alphaMapUv),T.push(w.lightMapUv),T.push(w.aoMapUv),T.push(w.bumpMapUv),T.push(w.normalMapUv),T.push(w.displacementMapUv),T.push(w.emissiveMapUv),T.push(w.metalnessMapUv),T.push(w.roughnessMapUv),T.push(w.anisotropyMapUv),T.push(w.clearcoatMapUv),T.push(w.clearcoatNormalMapUv),T.push(w.clearcoatRoughnessMapUv),T.push(w.iridescenceMapUv),T.push(w.iridescenceThicknessMapUv),T.push(w.sheenColorMapUv),T.push(w.sheenRoughnessMapUv),T.push(w.specularMapUv),T.push(w.specularColorMapUv),T.push(w.specularIntensityMapUv),T.push(w.transmissionMapUv),T.push(w.thicknessMapUv),T.push(w.combine),T.push(w.fogExp2),T.push(w.sizeAttenuation),T.push(w.morphTargetsCount),T.push(w.morphAttributeCount),T.push(w.numDirLights),T.push(w.numPointLights),T.push(w.numSpotLights),T.push(w.numSpotLightMaps),T.push(w.numHemiLights),T.push(w.numRectAreaLights),T.push(w.numDirLightShadows),T.push(w.numPointLightShadows),T.push(w.numSpotLightShadows),T.push(w.numSpotLightShadowsWithMaps),T.push(w.numLightProbes),T.push(w.shadowMapType),T.push(w.toneMapping),T.push(w.numClippingPlanes),T.push(w.numClipIntersection),T.push(w.depthPacking)}function S(T,w){a.disableAll(),w.supportsVertexTextures&&a.enable(0),w.instancing&&a.enable(1),w.instancingColor&&a.enable(2),w.instancingMorph&&a.enable(3),w.matcap&&a.enable(4),w.envMap&&a.enable(5),w.normalMapObjectSpace&&a.enable(6),w.normalMapTangentSpace&&a.enable(7),w.clearcoat&&a.enable(8),w.iridescence&&a.enable(9),w.alphaTest&&a.enable(10),w.vertexColors&&a.enable(11),w.vertexAlphas&&a.enable(12),w.vertexUv1s&&a.enable(13),w.vertexUv2s&&a.enable(14),w.vertexUv3s&&a.enable(15),w.vertexTangents&&a.enable(16),w.anisotropy&&a.enable(17),w.alphaHash&&a.enable(18),w.batching&&a.enable(19),w.dispersion&&a.enable(20),w.batchingColor&&a.enable(21),w.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),T.push(a.mask)}function v(T){let w=g[T.type],C;if(w){let k=ki[w];C=Am.clone(k.uniforms)}else C=T.uniforms;return C}function P(T,w){let C;for(let k=0,V=u.length;k<V;k++){let W=u[k];if(W.cacheKey===w){C=W,++C.usedTimes;break}}return C===void 0&&(C=new ES(i,w,T,r),u.push(C)),C}function A(T){if(--T.usedTimes===0){let w=u.indexOf(T);u[w]=u[u.length-1],u.pop(),T.destroy()}}function D(T){c.remove(T)}function F(){c.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:v,acquireProgram:P,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:F}}function CS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function RS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Qm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function eg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,d,f,g,x,m){let p=i[e];return p===void 0?(p={id:h.id,object:h,geometry:d,material:f,groupOrder:g,renderOrder:h.renderOrder,z:x,group:m},i[e]=p):(p.id=h.id,p.object=h,p.geometry=d,p.material=f,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=x,p.group=m),e++,p}function a(h,d,f,g,x,m){let p=o(h,d,f,g,x,m);f.transmission>0?n.push(p):f.transparent===!0?s.push(p):t.push(p)}function c(h,d,f,g,x,m){let p=o(h,d,f,g,x,m);f.transmission>0?n.unshift(p):f.transparent===!0?s.unshift(p):t.unshift(p)}function l(h,d){t.length>1&&t.sort(h||RS),n.length>1&&n.sort(d||Qm),s.length>1&&s.sort(d||Qm)}function u(){for(let h=e,d=i.length;h<d;h++){let f=i[h];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:c,finish:u,sort:l}}function PS(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new eg,i.set(n,[o])):s>=r.length?(o=new eg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function IS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new O,color:new tt};break;case"SpotLight":t={position:new O,direction:new O,color:new tt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new O,color:new tt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new O,skyColor:new tt,groundColor:new tt};break;case"RectAreaLight":t={color:new tt,position:new O,halfWidth:new O,halfHeight:new O};break}return i[e.id]=t,t}}}function LS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var DS=0;function NS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function US(i){let e=new IS,t=LS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new O);let s=new O,r=new Pt,o=new Pt;function a(l){let u=0,h=0,d=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let f=0,g=0,x=0,m=0,p=0,M=0,S=0,v=0,P=0,A=0,D=0;l.sort(NS);for(let T=0,w=l.length;T<w;T++){let C=l[T],k=C.color,V=C.intensity,W=C.distance,X=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=k.r*V,h+=k.g*V,d+=k.b*V;else if(C.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(C.sh.coefficients[q],V);D++}else if(C.isDirectionalLight){let q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let j=C.shadow,$=t.get(C);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,n.directionalShadow[f]=$,n.directionalShadowMap[f]=X,n.directionalShadowMatrix[f]=C.shadow.matrix,M++}n.directional[f]=q,f++}else if(C.isSpotLight){let q=e.get(C);q.position.setFromMatrixPosition(C.matrixWorld),q.color.copy(k).multiplyScalar(V),q.distance=W,q.coneCos=Math.cos(C.angle),q.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),q.decay=C.decay,n.spot[x]=q;let j=C.shadow;if(C.map&&(n.spotLightMap[P]=C.map,P++,j.updateMatrices(C),C.castShadow&&A++),n.spotLightMatrix[x]=j.matrix,C.castShadow){let $=t.get(C);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,n.spotShadow[x]=$,n.spotShadowMap[x]=X,v++}x++}else if(C.isRectAreaLight){let q=e.get(C);q.color.copy(k).multiplyScalar(V),q.halfWidth.set(C.width*.5,0,0),q.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=q,m++}else if(C.isPointLight){let q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),q.distance=C.distance,q.decay=C.decay,C.castShadow){let j=C.shadow,$=t.get(C);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,$.shadowCameraNear=j.camera.near,$.shadowCameraFar=j.camera.far,n.pointShadow[g]=$,n.pointShadowMap[g]=X,n.pointShadowMatrix[g]=C.shadow.matrix,S++}n.point[g]=q,g++}else if(C.isHemisphereLight){let q=e.get(C);q.skyColor.copy(C.color).multiplyScalar(V),q.groundColor.copy(C.groundColor).multiplyScalar(V),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=we.LTC_FLOAT_1,n.rectAreaLTC2=we.LTC_FLOAT_2):(n.rectAreaLTC1=we.LTC_HALF_1,n.rectAreaLTC2=we.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let F=n.hash;(F.directionalLength!==f||F.pointLength!==g||F.spotLength!==x||F.rectAreaLength!==m||F.hemiLength!==p||F.numDirectionalShadows!==M||F.numPointShadows!==S||F.numSpotShadows!==v||F.numSpotMaps!==P||F.numLightProbes!==D)&&(n.directional.length=f,n.spot.length=x,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=v,n.spotShadowMap.length=v,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=v+P-A,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=D,F.directionalLength=f,F.pointLength=g,F.spotLength=x,F.rectAreaLength=m,F.hemiLength=p,F.numDirectionalShadows=M,F.numPointShadows=S,F.numSpotShadows=v,F.numSpotMaps=P,F.numLightProbes=D,n.version=DS++)}function c(l,u){let h=0,d=0,f=0,g=0,x=0,m=u.matrixWorldInverse;for(let p=0,M=l.length;p<M;p++){let S=l[p];if(S.isDirectionalLight){let v=n.directional[h];v.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),h++}else if(S.isSpotLight){let v=n.spot[f];v.position.setFromMatrixPosition(S.matrixWorld),v.position.applyMatrix4(m),v.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),f++}else if(S.isRectAreaLight){let v=n.rectArea[g];v.position.setFromMatrixPosition(S.matrixWorld),v.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),v.halfWidth.set(S.width*.5,0,0),v.halfHeight.set(0,S.height*.5,0),v.halfWidth.applyMatrix4(o),v.halfHeight.applyMatrix4(o),g++}else if(S.isPointLight){let v=n.point[d];v.position.setFromMatrixPosition(S.matrixWorld),v.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let v=n.hemi[x];v.direction.setFromMatrixPosition(S.matrixWorld),v.direction.transformDirection(m),x++}}}return{setup:a,setupView:c,state:n}}function tg(i){let e=new US(i),t=[],n=[];function s(u){l.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function c(u){e.setupView(t,u)}let l={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:l,setupLights:a,setupLightsView:c,pushLight:r,pushShadow:o}}function FS(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new tg(i),e.set(s,[a])):r>=o.length?(a=new tg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var OS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,kS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function BS(i,e,t){let n=new Jr,s=new be,r=new be,o=new $t,a=new Kl({depthPacking:mm}),c=new Jl,l={},u=t.maxTextureSize,h={[ji]:Un,[Un]:ji,[Fi]:Fi},d=new vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new be},radius:{value:4}},vertexShader:OS,fragmentShader:kS}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Jt;g.setAttribute("position",new nn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Wt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Hu;let p=this.type;this.render=function(A,D,F){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;let T=i.getRenderTarget(),w=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),k=i.state;k.setBlending(es),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=p!==Ui&&this.type===Ui,W=p===Ui&&this.type!==Ui;for(let X=0,q=A.length;X<q;X++){let j=A[X],$=j.shadow;if($===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if($.autoUpdate===!1&&$.needsUpdate===!1)continue;s.copy($.mapSize);let ae=$.getFrameExtents();if(s.multiply(ae),r.copy($.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,$.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,$.mapSize.y=r.y)),$.map===null||V===!0||W===!0){let xe=this.type!==Ui?{minFilter:oi,magFilter:oi}:{};$.map!==null&&$.map.dispose(),$.map=new Li(s.x,s.y,xe),$.map.texture.name=j.name+".shadowMap",$.camera.updateProjectionMatrix()}i.setRenderTarget($.map),i.clear();let le=$.getViewportCount();for(let xe=0;xe<le;xe++){let Me=$.getViewport(xe);o.set(r.x*Me.x,r.y*Me.y,r.x*Me.z,r.y*Me.w),k.viewport(o),$.updateMatrices(j,xe),n=$.getFrustum(),v(D,F,$.camera,j,this.type)}$.isPointLightShadow!==!0&&this.type===Ui&&M($,F),$.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(T,w,C)};function M(A,D){let F=e.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Li(s.x,s.y)),d.uniforms.shadow_pass.value=A.map.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(D,null,F,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(D,null,F,f,x,null)}function S(A,D,F,T){let w=null,C=F.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)w=C;else if(w=F.isPointLight===!0?c:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let k=w.uuid,V=D.uuid,W=l[k];W===void 0&&(W={},l[k]=W);let X=W[V];X===void 0&&(X=w.clone(),W[V]=X,D.addEventListener("dispose",P)),w=X}if(w.visible=D.visible,w.wireframe=D.wireframe,T===Ui?w.side=D.shadowSide!==null?D.shadowSide:D.side:w.side=D.shadowSide!==null?D.shadowSide:h[D.side],w.alphaMap=D.alphaMap,w.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,w.map=D.map,w.clipShadows=D.clipShadows,w.clippingPlanes=D.clippingPlanes,w.clipIntersection=D.clipIntersection,w.displacementMap=D.displacementMap,w.displacementScale=D.displacementScale,w.displacementBias=D.displacementBias,w.wireframeLinewidth=D.wireframeLinewidth,w.linewidth=D.linewidth,F.isPointLight===!0&&w.isMeshDistanceMaterial===!0){let k=i.properties.get(w);k.light=F}return w}function v(A,D,F,T,w){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&w===Ui)&&(!A.frustumCulled||n.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(F.matrixWorldInverse,A.matrixWorld);let V=e.update(A),W=A.material;if(Array.isArray(W)){let X=V.groups;for(let q=0,j=X.length;q<j;q++){let $=X[q],ae=W[$.materialIndex];if(ae&&ae.visible){let le=S(A,ae,T,w);A.onBeforeShadow(i,A,D,F,V,le,$),i.renderBufferDirect(F,null,V,le,A,$),A.onAfterShadow(i,A,D,F,V,le,$)}}}else if(W.visible){let X=S(A,W,T,w);A.onBeforeShadow(i,A,D,F,V,X,null),i.renderBufferDirect(F,null,V,X,A,null),A.onAfterShadow(i,A,D,F,V,X,null)}}let k=A.children;for(let V=0,W=k.length;V<W;V++)v(k[V],D,F,T,w)}function P(A){A.target.removeEventListener("dispose",P);for(let F in l){let T=l[F],w=A.target.uuid;w in T&&(T[w].dispose(),delete T[w])}}}var zS={[ac]:lc,[cc]:dc,[hc]:fc,[$s]:uc,[lc]:ac,[dc]:cc,[fc]:hc,[uc]:$s};function VS(i,e){function t(){let B=!1,de=new $t,pe=null,Ie=new $t(0,0,0,0);return{setMask:function(he){pe!==he&&!B&&(i.colorMask(he,he,he,he),pe=he)},setLocked:function(he){B=he},setClear:function(he,re,Oe,Qe,At){At===!0&&(he*=Qe,re*=Qe,Oe*=Qe),de.set(he,re,Oe,Qe),Ie.equals(de)===!1&&(i.clearColor(he,re,Oe,Qe),Ie.copy(de))},reset:function(){B=!1,pe=null,Ie.set(-1,0,0,0)}}}function n(){let B=!1,de=!1,pe=null,Ie=null,he=null;return{setReversed:function(re){if(de!==re){let Oe=e.get("EXT_clip_control");re?Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.ZERO_TO_ONE_EXT):Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.NEGATIVE_ONE_TO_ONE_EXT),de=re;let Qe=he;he=null,this.setClear(Qe)}},getReversed:function(){return de},setTest:function(re){re?ne(i.DEPTH_TEST):Ee(i.DEPTH_TEST)},setMask:function(re){pe!==re&&!B&&(i.depthMask(re),pe=re)},setFunc:function(re){if(de&&(re=zS[re]),Ie!==re){switch(re){case ac:i.depthFunc(i.NEVER);break;case lc:i.depthFunc(i.ALWAYS);break;case cc:i.depthFunc(i.LESS);break;case $s:i.depthFunc(i.LEQUAL);break;case hc:i.depthFunc(i.EQUAL);break;case uc:i.depthFunc(i.GEQUAL);break;case dc:i.depthFunc(i.GREATER);break;case fc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ie=re}},setLocked:function(re){B=re},setClear:function(re){he!==re&&(de&&(re=1-re),i.clearDepth(re),he=re)},reset:function(){B=!1,pe=null,Ie=null,he=null,de=!1}}}function s(){let B=!1,de=null,pe=null,Ie=null,he=null,re=null,Oe=null,Qe=null,At=null;return{setTest:function(pt){B||(pt?ne(i.STENCIL_TEST):Ee(i.STENCIL_TEST))},setMask:function(pt){de!==pt&&!B&&(i.stencilMask(pt),de=pt)},setFunc:function(pt,_n,Lt){(pe!==pt||Ie!==_n||he!==Lt)&&(i.stencilFunc(pt,_n,Lt),pe=pt,Ie=_n,he=Lt)},setOp:function(pt,_n,Lt){(re!==pt||Oe!==_n||Qe!==Lt)&&(i.stencilOp(pt,_n,Lt),re=pt,Oe=_n,Qe=Lt)},setLocked:function(pt){B=pt},setClear:function(pt){At!==pt&&(i.clearStencil(pt),At=pt)},reset:function(){B=!1,de=null,pe=null,Ie=null,he=null,re=null,Oe=null,Qe=null,At=null}}}let r=new t,o=new n,a=new s,c=new WeakMap,l=new WeakMap,u={},h={},d=new WeakMap,f=[],g=null,x=!1,m=null,p=null,M=null,S=null,v=null,P=null,A=null,D=new tt(0,0,0),F=0,T=!1,w=null,C=null,k=null,V=null,W=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,j=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec($)[1]),q=j>=1):$.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),q=j>=2);let ae=null,le={},xe=i.getParameter(i.SCISSOR_BOX),Me=i.getParameter(i.VIEWPORT),_e=new $t().fromArray(xe),nt=new $t().fromArray(Me);function Je(B,de,pe,Ie){let he=new Uint8Array(4),re=i.createTexture();i.bindTexture(B,re),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Oe=0;Oe<pe;Oe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(de,0,i.RGBA,1,1,Ie,0,i.RGBA,i.UNSIGNED_BYTE,he):i.texImage2D(de+Oe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,he);return re}let Q={};Q[i.TEXTURE_2D]=Je(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=Je(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[i.TEXTURE_2D_ARRAY]=Je(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=Je(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(i.DEPTH_TEST),o.setFunc($s),We(!1),Ue(Vu),ne(i.CULL_FACE),dt(es);function ne(B){u[B]!==!0&&(i.enable(B),u[B]=!0)}function Ee(B){u[B]!==!1&&(i.disable(B),u[B]=!1)}function ze(B,de){return h[B]!==de?(i.bindFramebuffer(B,de),h[B]=de,B===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=de),B===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=de),!0):!1}function ve(B,de){let pe=f,Ie=!1;if(B){pe=d.get(de),pe===void 0&&(pe=[],d.set(de,pe));let he=B.textures;if(pe.length!==he.length||pe[0]!==i.COLOR_ATTACHMENT0){for(let re=0,Oe=he.length;re<Oe;re++)pe[re]=i.COLOR_ATTACHMENT0+re;pe.length=he.length,Ie=!0}}else pe[0]!==i.BACK&&(pe[0]=i.BACK,Ie=!0);Ie&&i.drawBuffers(pe)}function je(B){return g!==B?(i.useProgram(B),g=B,!0):!1}let Ut={[bs]:i.FUNC_ADD,[Vp]:i.FUNC_SUBTRACT,[Hp]:i.FUNC_REVERSE_SUBTRACT};Ut[Gp]=i.MIN,Ut[Wp]=i.MAX;let N={[Xp]:i.ZERO,[qp]:i.ONE,[Yp]:i.SRC_COLOR,[Il]:i.SRC_ALPHA,[Qp]:i.SRC_ALPHA_SATURATE,[Jp]:i.DST_COLOR,[Zp]:i.DST_ALPHA,[$p]:i.ONE_MINUS_SRC_COLOR,[Ll]:i.ONE_MINUS_SRC_ALPHA,[jp]:i.ONE_MINUS_DST_COLOR,[Kp]:i.ONE_MINUS_DST_ALPHA,[em]:i.CONSTANT_COLOR,[tm]:i.ONE_MINUS_CONSTANT_COLOR,[nm]:i.CONSTANT_ALPHA,[im]:i.ONE_MINUS_CONSTANT_ALPHA};function dt(B,de,pe,Ie,he,re,Oe,Qe,At,pt){if(B===es){x===!0&&(Ee(i.BLEND),x=!1);return}if(x===!1&&(ne(i.BLEND),x=!0),B!==zp){if(B!==m||pt!==T){if((p!==bs||v!==bs)&&(i.blendEquation(i.FUNC_ADD),p=bs,v=bs),pt)switch(B){case Ys:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gu:i.blendFunc(i.ONE,i.ONE);break;case Wu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Xu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}else switch(B){case Ys:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Wu:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xu:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}M=null,S=null,P=null,A=null,D.set(0,0,0),F=0,m=B,T=pt}return}he=he||de,re=re||pe,Oe=Oe||Ie,(de!==p||he!==v)&&(i.blendEquationSeparate(Ut[de],Ut[he]),p=de,v=he),(pe!==M||Ie!==S||re!==P||Oe!==A)&&(i.blendFuncSeparate(N[pe],N[Ie],N[re],N[Oe]),M=pe,S=Ie,P=re,A=Oe),(Qe.equals(D)===!1||At!==F)&&(i.blendColor(Qe.r,Qe.g,Qe.b,At),D.copy(Qe),F=At),m=B,T=!1}function $e(B,de){B.side===Fi?Ee(i.CULL_FACE):ne(i.CULL_FACE);let pe=B.side===Un;de&&(pe=!pe),We(pe),B.blending===Ys&&B.transparent===!1?dt(es):dt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Ie=B.stencilWrite;a.setTest(Ie),Ie&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Pe(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?ne(i.SAMPLE_ALPHA_TO_COVERAGE):Ee(i.SAMPLE_ALPHA_TO_COVERAGE)}function We(B){w!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),w=B)}function Ue(B){B!==Op?(ne(i.CULL_FACE),B!==C&&(B===Vu?i.cullFace(i.BACK):B===kp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ee(i.CULL_FACE),C=B}function St(B){B!==k&&(q&&i.lineWidth(B),k=B)}function Pe(B,de,pe){B?(ne(i.POLYGON_OFFSET_FILL),(V!==de||W!==pe)&&(i.polygonOffset(de,pe),V=de,W=pe)):Ee(i.POLYGON_OFFSET_FILL)}function Ge(B){B?ne(i.SCISSOR_TEST):Ee(i.SCISSOR_TEST)}function Bt(B){B===void 0&&(B=i.TEXTURE0+X-1),ae!==B&&(i.activeTexture(B),ae=B)}function vt(B,de,pe){pe===void 0&&(ae===null?pe=i.TEXTURE0+X-1:pe=ae);let Ie=le[pe];Ie===void 0&&(Ie={type:void 0,texture:void 0},le[pe]=Ie),(Ie.type!==B||Ie.texture!==de)&&(ae!==pe&&(i.activeTexture(pe),ae=pe),i.bindTexture(B,de||Q[B]),Ie.type=B,Ie.texture=de)}function I(){let B=le[ae];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function y(){try{i.compressedTexImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function U(){try{i.compressedTexImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function K(){try{i.texSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function ie(){try{i.texSubImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function te(){try{i.compressedTexSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Fe(){try{i.compressedTexSubImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function ue(){try{i.texStorage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Le(){try{i.texStorage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Ce(){try{i.texImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function oe(){try{i.texImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function ge(B){_e.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),_e.copy(B))}function Be(B){nt.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),nt.copy(B))}function ke(B,de){let pe=l.get(de);pe===void 0&&(pe=new WeakMap,l.set(de,pe));let Ie=pe.get(B);Ie===void 0&&(Ie=i.getUniformBlockIndex(de,B.name),pe.set(B,Ie))}function ye(B,de){let Ie=l.get(de).get(B);c.get(de)!==Ie&&(i.uniformBlockBinding(de,Ie,B.__bindingPointIndex),c.set(de,Ie))}function Ke(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},ae=null,le={},h={},d=new WeakMap,f=[],g=null,x=!1,m=null,p=null,M=null,S=null,v=null,P=null,A=null,D=new tt(0,0,0),F=0,T=!1,w=null,C=null,k=null,V=null,W=null,_e.set(0,0,i.canvas.width,i.canvas.height),nt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:Ee,bindFramebuffer:ze,drawBuffers:ve,useProgram:je,setBlending:dt,setMaterial:$e,setFlipSided:We,setCullFace:Ue,setLineWidth:St,setPolygonOffset:Pe,setScissorTest:Ge,activeTexture:Bt,bindTexture:vt,unbindTexture:I,compressedTexImage2D:y,compressedTexImage3D:U,texImage2D:Ce,texImage3D:oe,updateUBOMapping:ke,uniformBlockBinding:ye,texStorage2D:ue,texStorage3D:Le,texSubImage2D:K,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Fe,scissor:ge,viewport:Be,reset:Ke}}function HS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new be,u=new WeakMap,h,d=new WeakMap,f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,y){return f?new OffscreenCanvas(I,y):Yo("canvas")}function x(I,y,U){let K=1,ie=vt(I);if((ie.width>U||ie.height>U)&&(K=U/Math.max(ie.width,ie.height)),K<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let te=Math.floor(K*ie.width),Fe=Math.floor(K*ie.height);h===void 0&&(h=g(te,Fe));let ue=y?g(te,Fe):h;return ue.width=te,ue.height=Fe,ue.getContext("2d").drawImage(I,0,0,te,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Fe+")."),ue}else return"data"in I&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),I;return I}function m(I){return I.generateMipmaps}function p(I){i.generateMipmap(I)}function M(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(I,y,U,K,ie=!1){if(I!==null){if(i[I]!==void 0)return i[I];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let te=y;if(y===i.RED&&(U===i.FLOAT&&(te=i.R32F),U===i.HALF_FLOAT&&(te=i.R16F),U===i.UNSIGNED_BYTE&&(te=i.R8)),y===i.RED_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.R8UI),U===i.UNSIGNED_SHORT&&(te=i.R16UI),U===i.UNSIGNED_INT&&(te=i.R32UI),U===i.BYTE&&(te=i.R8I),U===i.SHORT&&(te=i.R16I),U===i.INT&&(te=i.R32I)),y===i.RG&&(U===i.FLOAT&&(te=i.RG32F),U===i.HALF_FLOAT&&(te=i.RG16F),U===i.UNSIGNED_BYTE&&(te=i.RG8)),y===i.RG_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RG8UI),U===i.UNSIGNED_SHORT&&(te=i.RG16UI),U===i.UNSIGNED_INT&&(te=i.RG32UI),U===i.BYTE&&(te=i.RG8I),U===i.SHORT&&(te=i.RG16I),U===i.INT&&(te=i.RG32I)),y===i.RGB_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RGB8UI),U===i.UNSIGNED_SHORT&&(te=i.RGB16UI),U===i.UNSIGNED_INT&&(te=i.RGB32UI),U===i.BYTE&&(te=i.RGB8I),U===i.SHORT&&(te=i.RGB16I),U===i.INT&&(te=i.RGB32I)),y===i.RGBA_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),U===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),U===i.UNSIGNED_INT&&(te=i.RGBA32UI),U===i.BYTE&&(te=i.RGBA8I),U===i.SHORT&&(te=i.RGBA16I),U===i.INT&&(te=i.RGBA32I)),y===i.RGB&&(U===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),U===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),y===i.RGBA){let Fe=ie?Xo:ft.getTransfer(K);U===i.FLOAT&&(te=i.RGBA32F),U===i.HALF_FLOAT&&(te=i.RGBA16F),U===i.UNSIGNED_BYTE&&(te=Fe===Et?i.SRGB8_ALPHA8:i.RGBA8),U===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),U===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(I,y){let U;return I?y===null||y===Is||y===so?U=i.DEPTH24_STENCIL8:y===Oi?U=i.DEPTH32F_STENCIL8:y===no&&(U=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Is||y===so?U=i.DEPTH_COMPONENT24:y===Oi?U=i.DEPTH_COMPONENT32F:y===no&&(U=i.DEPTH_COMPONENT16),U}function P(I,y){return m(I)===!0||I.isFramebufferTexture&&I.minFilter!==oi&&I.minFilter!==xi?Math.log2(Math.max(y.width,y.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?y.mipmaps.length:1}function A(I){let y=I.target;y.removeEventListener("dispose",A),F(y),y.isVideoTexture&&u.delete(y)}function D(I){let y=I.target;y.removeEventListener("dispose",D),w(y)}function F(I){let y=n.get(I);if(y.__webglInit===void 0)return;let U=I.source,K=d.get(U);if(K){let ie=K[y.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&T(I),Object.keys(K).length===0&&d.delete(U)}n.remove(I)}function T(I){let y=n.get(I);i.deleteTexture(y.__webglTexture);let U=I.source,K=d.get(U);delete K[y.__cacheKey],o.memory.textures--}function w(I){let y=n.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),n.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(y.__webglFramebuffer[K]))for(let ie=0;ie<y.__webglFramebuffer[K].length;ie++)i.deleteFramebuffer(y.__webglFramebuffer[K][ie]);else i.deleteFramebuffer(y.__webglFramebuffer[K]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[K])}else{if(Array.isArray(y.__webglFramebuffer))for(let K=0;K<y.__webglFramebuffer.length;K++)i.deleteFramebuffer(y.__webglFramebuffer[K]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let K=0;K<y.__webglColorRenderbuffer.length;K++)y.__webglColorRenderbuffer[K]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[K]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let U=I.textures;for(let K=0,ie=U.length;K<ie;K++){let te=n.get(U[K]);te.__webglTexture&&(i.deleteTexture(te.__webglTexture),o.memory.textures--),n.remove(U[K])}n.remove(I)}let C=0;function k(){C=0}function V(){let I=C;return I>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),C+=1,I}function W(I){let y=[];return y.push(I.wrapS),y.push(I.wrapT),y.push(I.wrapR||0),y.push(I.magFilter),y.push(I.minFilter),y.push(I.anisotropy),y.push(I.internalFormat),y.push(I.format),y.push(I.type),y.push(I.generateMipmaps),y.push(I.premultiplyAlpha),y.push(I.flipY),y.push(I.unpackAlignment),y.push(I.colorSpace),y.join()}function X(I,y){let U=n.get(I);if(I.isVideoTexture&&Ge(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&U.__version!==I.version){let K=I.image;if(K===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(U,I,y);return}}else I.isExternalTexture&&(U.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,U.__webglTexture,i.TEXTURE0+y)}function q(I,y){let U=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&U.__version!==I.version){Q(U,I,y);return}t.bindTexture(i.TEXTURE_2D_ARRAY,U.__webglTexture,i.TEXTURE0+y)}function j(I,y){let U=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&U.__version!==I.version){Q(U,I,y);return}t.bindTexture(i.TEXTURE_3D,U.__webglTexture,i.TEXTURE0+y)}function $(I,y){let U=n.get(I);if(I.version>0&&U.__version!==I.version){ne(U,I,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,U.__webglTexture,i.TEXTURE0+y)}let ae={[Dl]:i.REPEAT,[ys]:i.CLAMP_TO_EDGE,[Nl]:i.MIRRORED_REPEAT},le={[oi]:i.NEAREST,[fm]:i.NEAREST_MIPMAP_NEAREST,[wa]:i.NEAREST_MIPMAP_LINEAR,[xi]:i.LINEAR,[_c]:i.LINEAR_MIPMAP_NEAREST,[Ps]:i.LINEAR_MIPMAP_LINEAR},xe={[_m]:i.NEVER,[Sm]:i.ALWAYS,[xm]:i.LESS,[nd]:i.LEQUAL,[vm]:i.EQUAL,[Mm]:i.GEQUAL,[ym]:i.GREATER,[bm]:i.NOTEQUAL};function Me(I,y){if(y.type===Oi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===xi||y.magFilter===_c||y.magFilter===wa||y.magFilter===Ps||y.minFilter===xi||y.minFilter===_c||y.minFilter===wa||y.minFilter===Ps)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,ae[y.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,ae[y.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,ae[y.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,le[y.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,le[y.minFilter]),y.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,xe[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===oi||y.minFilter!==wa&&y.minFilter!==Ps||y.type===Oi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let U=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function _e(I,y){let U=!1;I.__webglInit===void 0&&(I.__webglInit=!0,y.addEventListener("dispose",A));let K=y.source,ie=d.get(K);ie===void 0&&(ie={},d.set(K,ie));let te=W(y);if(te!==I.__cacheKey){ie[te]===void 0&&(ie[te]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,U=!0),ie[te].usedTimes++;let Fe=ie[I.__cacheKey];Fe!==void 0&&(ie[I.__cacheKey].usedTimes--,Fe.usedTimes===0&&T(y)),I.__cacheKey=te,I.__webglTexture=ie[te].texture}return U}function nt(I,y,U){return Math.floor(Math.floor(I/U)/y)}function Je(I,y,U,K){let te=I.updateRanges;if(te.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,U,K,y.data);else{te.sort((oe,ge)=>oe.start-ge.start);let Fe=0;for(let oe=1;oe<te.length;oe++){let ge=te[Fe],Be=te[oe],ke=ge.start+ge.count,ye=nt(Be.start,y.width,4),Ke=nt(ge.start,y.width,4);Be.start<=ke+1&&ye===Ke&&nt(Be.start+Be.count-1,y.width,4)===ye?ge.count=Math.max(ge.count,Be.start+Be.count-ge.start):(++Fe,te[Fe]=Be)}te.length=Fe+1;let ue=i.getParameter(i.UNPACK_ROW_LENGTH),Le=i.getParameter(i.UNPACK_SKIP_PIXELS),Ce=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let oe=0,ge=te.length;oe<ge;oe++){let Be=te[oe],ke=Math.floor(Be.start/4),ye=Math.ceil(Be.count/4),Ke=ke%y.width,B=Math.floor(ke/y.width),de=ye,pe=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ke),i.pixelStorei(i.UNPACK_SKIP_ROWS,B),t.texSubImage2D(i.TEXTURE_2D,0,Ke,B,de,pe,U,K,y.data)}I.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ue),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Le),i.pixelStorei(i.UNPACK_SKIP_ROWS,Ce)}}function Q(I,y,U){let K=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(K=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(K=i.TEXTURE_3D);let ie=_e(I,y),te=y.source;t.bindTexture(K,I.__webglTexture,i.TEXTURE0+U);let Fe=n.get(te);if(te.version!==Fe.__version||ie===!0){t.activeTexture(i.TEXTURE0+U);let ue=ft.getPrimaries(ft.workingColorSpace),Le=y.colorSpace===ns?null:ft.getPrimaries(y.colorSpace),Ce=y.colorSpace===ns||ue===Le?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ce);let oe=x(y.image,!1,s.maxTextureSize);oe=Bt(y,oe);let ge=r.convert(y.format,y.colorSpace),Be=r.convert(y.type),ke=S(y.internalFormat,ge,Be,y.colorSpace,y.isVideoTexture);Me(K,y);let ye,Ke=y.mipmaps,B=y.isVideoTexture!==!0,de=Fe.__version===void 0||ie===!0,pe=te.dataReady,Ie=P(y,oe);if(y.isDepthTexture)ke=v(y.format===ro,y.type),de&&(B?t.texStorage2D(i.TEXTURE_2D,1,ke,oe.width,oe.height):t.texImage2D(i.TEXTURE_2D,0,ke,oe.width,oe.height,0,ge,Be,null));else if(y.isDataTexture)if(Ke.length>0){B&&de&&t.texStorage2D(i.TEXTURE_2D,Ie,ke,Ke[0].width,Ke[0].height);for(let he=0,re=Ke.length;he<re;he++)ye=Ke[he],B?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ye.width,ye.height,ge,Be,ye.data):t.texImage2D(i.TEXTURE_2D,he,ke,ye.width,ye.height,0,ge,Be,ye.data);y.generateMipmaps=!1}else B?(de&&t.texStorage2D(i.TEXTURE_2D,Ie,ke,oe.width,oe.height),pe&&Je(y,oe,ge,Be)):t.texImage2D(i.TEXTURE_2D,0,ke,oe.width,oe.height,0,ge,Be,oe.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){B&&de&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ie,ke,Ke[0].width,Ke[0].height,oe.depth);for(let he=0,re=Ke.length;he<re;he++)if(ye=Ke[he],y.format!==ai)if(ge!==null)if(B){if(pe)if(y.layerUpdates.size>0){let Oe=hd(ye.width,ye.height,y.format,y.type);for(let Qe of y.layerUpdates){let At=ye.data.subarray(Qe*Oe/ye.data.BYTES_PER_ELEMENT,(Qe+1)*Oe/ye.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Qe,ye.width,ye.height,1,ge,At)}y.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ye.width,ye.height,oe.depth,ge,ye.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,ke,ye.width,ye.height,oe.depth,0,ye.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else B?pe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ye.width,ye.height,oe.depth,ge,Be,ye.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,ke,ye.width,ye.height,oe.depth,0,ge,Be,ye.data)}else{B&&de&&t.texStorage2D(i.TEXTURE_2D,Ie,ke,Ke[0].width,Ke[0].height);for(let he=0,re=Ke.length;he<re;he++)ye=Ke[he],y.format!==ai?ge!==null?B?pe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ye.width,ye.height,ge,ye.data):t.compressedTexImage2D(i.TEXTURE_2D,he,ke,ye.width,ye.height,0,ye.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):B?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ye.width,ye.height,ge,Be,ye.data):t.texImage2D(i.TEXTURE_2D,he,ke,ye.width,ye.height,0,ge,Be,ye.data)}else if(y.isDataArrayTexture)if(B){if(de&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ie,ke,oe.width,oe.height,oe.depth),pe)if(y.layerUpdates.size>0){let he=hd(oe.width,oe.height,y.format,y.type);for(let re of y.layerUpdates){let Oe=oe.data.subarray(re*he/oe.data.BYTES_PER_ELEMENT,(re+1)*he/oe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,re,oe.width,oe.height,1,ge,Be,Oe)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,oe.width,oe.height,oe.depth,ge,Be,oe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ke,oe.width,oe.height,oe.depth,0,ge,Be,oe.data);else if(y.isData3DTexture)B?(de&&t.texStorage3D(i.TEXTURE_3D,Ie,ke,oe.width,oe.height,oe.depth),pe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,oe.width,oe.height,oe.depth,ge,Be,oe.data)):t.texImage3D(i.TEXTURE_3D,0,ke,oe.width,oe.height,oe.depth,0,ge,Be,oe.data);else if(y.isFramebufferTexture){if(de)if(B)t.texStorage2D(i.TEXTURE_2D,Ie,ke,oe.width,oe.height);else{let he=oe.width,re=oe.height;for(let Oe=0;Oe<Ie;Oe++)t.texImage2D(i.TEXTURE_2D,Oe,ke,he,re,0,ge,Be,null),he>>=1,re>>=1}}else if(Ke.length>0){if(B&&de){let he=vt(Ke[0]);t.texStorage2D(i.TEXTURE_2D,Ie,ke,he.width,he.height)}for(let he=0,re=Ke.length;he<re;he++)ye=Ke[he],B?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ge,Be,ye):t.texImage2D(i.TEXTURE_2D,he,ke,ge,Be,ye);y.generateMipmaps=!1}else if(B){if(de){let he=vt(oe);t.texStorage2D(i.TEXTURE_2D,Ie,ke,he.width,he.height)}pe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ge,Be,oe)}else t.texImage2D(i.TEXTURE_2D,0,ke,ge,Be,oe);m(y)&&p(K),Fe.__version=te.version,y.onUpdate&&y.onUpdate(y)}I.__version=y.version}function ne(I,y,U){if(y.image.length!==6)return;let K=_e(I,y),ie=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+U);let te=n.get(ie);if(ie.version!==te.__version||K===!0){t.activeTexture(i.TEXTURE0+U);let Fe=ft.getPrimaries(ft.workingColorSpace),ue=y.colorSpace===ns?null:ft.getPrimaries(y.colorSpace),Le=y.colorSpace===ns||Fe===ue?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Le);let Ce=y.isCompressedTexture||y.image[0].isCompressedTexture,oe=y.image[0]&&y.image[0].isDataTexture,ge=[];for(let re=0;re<6;re++)!Ce&&!oe?ge[re]=x(y.image[re],!0,s.maxCubemapSize):ge[re]=oe?y.image[re].image:y.image[re],ge[re]=Bt(y,ge[re]);let Be=ge[0],ke=r.convert(y.format,y.colorSpace),ye=r.convert(y.type),Ke=S(y.internalFormat,ke,ye,y.colorSpace),B=y.isVideoTexture!==!0,de=te.__version===void 0||K===!0,pe=ie.dataReady,Ie=P(y,Be);Me(i.TEXTURE_CUBE_MAP,y);let he;if(Ce){B&&de&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,Ke,Be.width,Be.height);for(let re=0;re<6;re++){he=ge[re].mipmaps;for(let Oe=0;Oe<he.length;Oe++){let Qe=he[Oe];y.format!==ai?ke!==null?B?pe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe,0,0,Qe.width,Qe.height,ke,Qe.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe,Ke,Qe.width,Qe.height,0,Qe.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):B?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe,0,0,Qe.width,Qe.height,ke,ye,Qe.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe,Ke,Qe.width,Qe.height,0,ke,ye,Qe.data)}}}else{if(he=y.mipmaps,B&&de){he.length>0&&Ie++;let re=vt(ge[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,Ke,re.width,re.height)}for(let re=0;re<6;re++)if(oe){B?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ge[re].width,ge[re].height,ke,ye,ge[re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Ke,ge[re].width,ge[re].height,0,ke,ye,ge[re].data);for(let Oe=0;Oe<he.length;Oe++){let At=he[Oe].image[re].image;B?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe+1,0,0,At.width,At.height,ke,ye,At.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe+1,Ke,At.width,At.height,0,ke,ye,At.data)}}else{B?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ke,ye,ge[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Ke,ke,ye,ge[re]);for(let Oe=0;Oe<he.length;Oe++){let Qe=he[Oe];B?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe+1,0,0,ke,ye,Qe.image[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Oe+1,Ke,ke,ye,Qe.image[re])}}}m(y)&&p(i.TEXTURE_CUBE_MAP),te.__version=ie.version,y.onUpdate&&y.onUpdate(y)}I.__version=y.version}function Ee(I,y,U,K,ie,te){let Fe=r.convert(U.format,U.colorSpace),ue=r.convert(U.type),Le=S(U.internalFormat,Fe,ue,U.colorSpace),Ce=n.get(y),oe=n.get(U);if(oe.__renderTarget=y,!Ce.__hasExternalTextures){let ge=Math.max(1,y.width>>te),Be=Math.max(1,y.height>>te);ie===i.TEXTURE_3D||ie===i.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,Le,ge,Be,y.depth,0,Fe,ue,null):t.texImage2D(ie,te,Le,ge,Be,0,Fe,ue,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Pe(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,K,ie,oe.__webglTexture,0,St(y)):(ie===i.TEXTURE_2D||ie>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,K,ie,oe.__webglTexture,te),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ze(I,y,U){if(i.bindRenderbuffer(i.RENDERBUFFER,I),y.depthBuffer){let K=y.depthTexture,ie=K&&K.isDepthTexture?K.type:null,te=v(y.stencilBuffer,ie),Fe=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=St(y);Pe(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ue,te,y.width,y.height):U?i.renderbufferStorageMultisample(i.RENDERBUFFER,ue,te,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,te,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Fe,i.RENDERBUFFER,I)}else{let K=y.textures;for(let ie=0;ie<K.length;ie++){let te=K[ie],Fe=r.convert(te.format,te.colorSpace),ue=r.convert(te.type),Le=S(te.internalFormat,Fe,ue,te.colorSpace),Ce=St(y);U&&Pe(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ce,Le,y.width,y.height):Pe(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ce,Le,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,Le,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ve(I,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let K=n.get(y.depthTexture);K.__renderTarget=y,(!K.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),X(y.depthTexture,0);let ie=K.__webglTexture,te=St(y);if(y.depthTexture.format===Xr)Pe(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0);else if(y.depthTexture.format===ro)Pe(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function je(I){let y=n.get(I),U=I.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==I.depthTexture){let K=I.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),K){let ie=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,K.removeEventListener("dispose",ie)};K.addEventListener("dispose",ie),y.__depthDisposeCallback=ie}y.__boundDepthTexture=K}if(I.depthTexture&&!y.__autoAllocateDepthBuffer){if(U)throw new Error("target.depthTexture not supported in Cube render targets");let K=I.texture.mipmaps;K&&K.length>0?ve(y.__webglFramebuffer[0],I):ve(y.__webglFramebuffer,I)}else if(U){y.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[K]),y.__webglDepthbuffer[K]===void 0)y.__webglDepthbuffer[K]=i.createRenderbuffer(),ze(y.__webglDepthbuffer[K],I,!1);else{let ie=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=y.__webglDepthbuffer[K];i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}else{let K=I.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),ze(y.__webglDepthbuffer,I,!1);else{let ie=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(I,y,U){let K=n.get(I);y!==void 0&&Ee(K.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),U!==void 0&&je(I)}function N(I){let y=I.texture,U=n.get(I),K=n.get(y);I.addEventListener("dispose",D);let ie=I.textures,te=I.isWebGLCubeRenderTarget===!0,Fe=ie.length>1;if(Fe||(K.__webglTexture===void 0&&(K.__webglTexture=i.createTexture()),K.__version=y.version,o.memory.textures++),te){U.__webglFramebuffer=[];for(let ue=0;ue<6;ue++)if(y.mipmaps&&y.mipmaps.length>0){U.__webglFramebuffer[ue]=[];for(let Le=0;Le<y.mipmaps.length;Le++)U.__webglFramebuffer[ue][Le]=i.createFramebuffer()}else U.__webglFramebuffer[ue]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){U.__webglFramebuffer=[];for(let ue=0;ue<y.mipmaps.length;ue++)U.__webglFramebuffer[ue]=i.createFramebuffer()}else U.__webglFramebuffer=i.createFramebuffer();if(Fe)for(let ue=0,Le=ie.length;ue<Le;ue++){let Ce=n.get(ie[ue]);Ce.__webglTexture===void 0&&(Ce.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Pe(I)===!1){U.__webglMultisampledFramebuffer=i.createFramebuffer(),U.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let ue=0;ue<ie.length;ue++){let Le=ie[ue];U.__webglColorRenderbuffer[ue]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,U.__webglColorRenderbuffer[ue]);let Ce=r.convert(Le.format,Le.colorSpace),oe=r.convert(Le.type),ge=S(Le.internalFormat,Ce,oe,Le.colorSpace,I.isXRRenderTarget===!0),Be=St(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,Be,ge,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.RENDERBUFFER,U.__webglColorRenderbuffer[ue])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(U.__webglDepthRenderbuffer=i.createRenderbuffer(),ze(U.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(te){t.bindTexture(i.TEXTURE_CUBE_MAP,K.__webglTexture),Me(i.TEXTURE_CUBE_MAP,y);for(let ue=0;ue<6;ue++)if(y.mipmaps&&y.mipmaps.length>0)for(let Le=0;Le<y.mipmaps.length;Le++)Ee(U.__webglFramebuffer[ue][Le],I,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ue,Le);else Ee(U.__webglFramebuffer[ue],I,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ue,0);m(y)&&p(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let ue=0,Le=ie.length;ue<Le;ue++){let Ce=ie[ue],oe=n.get(Ce),ge=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ge=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ge,oe.__webglTexture),Me(ge,Ce),Ee(U.__webglFramebuffer,I,Ce,i.COLOR_ATTACHMENT0+ue,ge,0),m(Ce)&&p(ge)}t.unbindTexture()}else{let ue=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ue=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ue,K.__webglTexture),Me(ue,y),y.mipmaps&&y.mipmaps.length>0)for(let Le=0;Le<y.mipmaps.length;Le++)Ee(U.__webglFramebuffer[Le],I,y,i.COLOR_ATTACHMENT0,ue,Le);else Ee(U.__webglFramebuffer,I,y,i.COLOR_ATTACHMENT0,ue,0);m(y)&&p(ue),t.unbindTexture()}I.depthBuffer&&je(I)}function dt(I){let y=I.textures;for(let U=0,K=y.length;U<K;U++){let ie=y[U];if(m(ie)){let te=M(I),Fe=n.get(ie).__webglTexture;t.bindTexture(te,Fe),p(te),t.unbindTexture()}}}let $e=[],We=[];function Ue(I){if(I.samples>0){if(Pe(I)===!1){let y=I.textures,U=I.width,K=I.height,ie=i.COLOR_BUFFER_BIT,te=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Fe=n.get(I),ue=y.length>1;if(ue)for(let Ce=0;Ce<y.length;Ce++)t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);let Le=I.texture.mipmaps;Le&&Le.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Ce=0;Ce<y.length;Ce++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ie|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ie|=i.STENCIL_BUFFER_BIT)),ue){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Ce]);let oe=n.get(y[Ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,oe,0)}i.blitFramebuffer(0,0,U,K,0,0,U,K,ie,i.NEAREST),c===!0&&($e.length=0,We.length=0,$e.push(i.COLOR_ATTACHMENT0+Ce),I.depthBuffer&&I.resolveDepthBuffer===!1&&($e.push(te),We.push(te),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,We)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,$e))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ue)for(let Ce=0;Ce<y.length;Ce++){t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Ce]);let oe=n.get(y[Ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,oe,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&c){let y=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function St(I){return Math.min(s.maxSamples,I.samples)}function Pe(I){let y=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Ge(I){let y=o.render.frame;u.get(I)!==y&&(u.set(I,y),I.update())}function Bt(I,y){let U=I.colorSpace,K=I.format,ie=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||U!==Zs&&U!==ns&&(ft.getTransfer(U)===Et?(K!==ai||ie!==yi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",U)),y}function vt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=V,this.resetTextureUnits=k,this.setTexture2D=X,this.setTexture2DArray=q,this.setTexture3D=j,this.setTextureCube=$,this.rebindTextures=Ut,this.setupRenderTarget=N,this.updateRenderTargetMipmap=dt,this.updateMultisampleRenderTarget=Ue,this.setupDepthRenderbuffer=je,this.setupFrameBufferTexture=Ee,this.useMultisampledRTT=Pe}function GS(i,e){function t(n,s=ns){let r,o=ft.getTransfer(s);if(n===yi)return i.UNSIGNED_BYTE;if(n===vc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===yc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Zu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ku)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Yu)return i.BYTE;if(n===$u)return i.SHORT;if(n===no)return i.UNSIGNED_SHORT;if(n===xc)return i.INT;if(n===Is)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===io)return i.HALF_FLOAT;if(n===Ju)return i.ALPHA;if(n===ju)return i.RGB;if(n===ai)return i.RGBA;if(n===Xr)return i.DEPTH_COMPONENT;if(n===ro)return i.DEPTH_STENCIL;if(n===Qu)return i.RED;if(n===bc)return i.RED_INTEGER;if(n===ed)return i.RG;if(n===Mc)return i.RG_INTEGER;if(n===Sc)return i.RGBA_INTEGER;if(n===Ea||n===Ta||n===Aa||n===Ca)if(o===Et)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ea)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ea)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ta)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ca)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===wc||n===Ec||n===Tc||n===Ac)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===wc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ec)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Tc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Ac)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Cc||n===Rc||n===Pc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Cc||n===Rc)return o===Et?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Pc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Ic||n===Lc||n===Dc||n===Nc||n===Uc||n===Fc||n===Oc||n===kc||n===Bc||n===zc||n===Vc||n===Hc||n===Gc||n===Wc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ic)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Lc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Dc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Nc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Uc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Fc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Oc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===kc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Bc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===zc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Vc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Hc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Gc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Wc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Xc||n===qc||n===Yc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Xc)return o===Et?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===qc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Yc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===$c||n===Zc||n===Kc||n===Jc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===$c)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Zc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Kc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Jc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===so?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var WS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,XS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Sd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new na(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new vi({vertexShader:WS,fragmentShader:XS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Wt(new fa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},wd=class extends Ii{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,d=null,f=null,g=null,x=typeof XRWebGLBinding<"u",m=new Sd,p={},M=t.getContextAttributes(),S=null,v=null,P=[],A=[],D=new be,F=null,T=new gn;T.viewport=new $t;let w=new gn;w.viewport=new $t;let C=[T,w],k=new oc,V=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ne=P[Q];return ne===void 0&&(ne=new Kr,P[Q]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(Q){let ne=P[Q];return ne===void 0&&(ne=new Kr,P[Q]=ne),ne.getGripSpace()},this.getHand=function(Q){let ne=P[Q];return ne===void 0&&(ne=new Kr,P[Q]=ne),ne.getHandSpace()};function X(Q){let ne=A.indexOf(Q.inputSource);if(ne===-1)return;let Ee=P[ne];Ee!==void 0&&(Ee.update(Q.inputSource,Q.frame,l||o),Ee.dispatchEvent({type:Q.type,data:Q.inputSource}))}function q(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",j);for(let Q=0;Q<P.length;Q++){let ne=A[Q];ne!==null&&(A[Q]=null,P[Q].disconnect(ne))}V=null,W=null,m.reset();for(let Q in p)delete p[Q];e.setRenderTarget(S),f=null,d=null,h=null,s=null,v=null,Je.stop(),n.isPresenting=!1,e.setPixelRatio(F),e.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Q){l=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",q),s.addEventListener("inputsourceschange",j),M.xrCompatible!==!0&&await t.makeXRCompatible(),F=e.getPixelRatio(),e.getSize(D),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ee=null,ze=null,ve=null;M.depth&&(ve=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ee=M.stencil?ro:Xr,ze=M.stencil?so:Is);let je={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(je),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new Li(d.textureWidth,d.textureHeight,{format:ai,type:yi,depthTexture:new ta(d.textureWidth,d.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,Ee),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{let Ee={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Ee),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Li(f.framebufferWidth,f.framebufferHeight,{format:ai,type:yi,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),Je.setContext(s),Je.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(Q){for(let ne=0;ne<Q.removed.length;ne++){let Ee=Q.removed[ne],ze=A.indexOf(Ee);ze>=0&&(A[ze]=null,P[ze].disconnect(Ee))}for(let ne=0;ne<Q.added.length;ne++){let Ee=Q.added[ne],ze=A.indexOf(Ee);if(ze===-1){for(let je=0;je<P.length;je++)if(je>=A.length){A.push(Ee),ze=je;break}else if(A[je]===null){A[je]=Ee,ze=je;break}if(ze===-1)break}let ve=P[ze];ve&&ve.connect(Ee)}}let $=new O,ae=new O;function le(Q,ne,Ee){$.setFromMatrixPosition(ne.matrixWorld),ae.setFromMatrixPosition(Ee.matrixWorld);let ze=$.distanceTo(ae),ve=ne.projectionMatrix.elements,je=Ee.projectionMatrix.elements,Ut=ve[14]/(ve[10]-1),N=ve[14]/(ve[10]+1),dt=(ve[9]+1)/ve[5],$e=(ve[9]-1)/ve[5],We=(ve[8]-1)/ve[0],Ue=(je[8]+1)/je[0],St=Ut*We,Pe=Ut*Ue,Ge=ze/(-We+Ue),Bt=Ge*-We;if(ne.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Bt),Q.translateZ(Ge),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),ve[10]===-1)Q.projectionMatrix.copy(ne.projectionMatrix),Q.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{let vt=Ut+Ge,I=N+Ge,y=St-Bt,U=Pe+(ze-Bt),K=dt*N/I*vt,ie=$e*N/I*vt;Q.projectionMatrix.makePerspective(y,U,K,ie,vt,I),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function xe(Q,ne){ne===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ne.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ne=Q.near,Ee=Q.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(Ee=m.depthFar)),k.near=w.near=T.near=ne,k.far=w.far=T.far=Ee,(V!==k.near||W!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),V=k.near,W=k.far),k.layers.mask=Q.layers.mask|6,T.layers.mask=k.layers.mask&3,w.layers.mask=k.layers.mask&5;let ze=Q.parent,ve=k.cameras;xe(k,ze);for(let je=0;je<ve.length;je++)xe(ve[je],ze);ve.length===2?le(k,T,w):k.projectionMatrix.copy(T.projectionMatrix),Me(Q,k,ze)};function Me(Q,ne,Ee){Ee===null?Q.matrix.copy(ne.matrixWorld):(Q.matrix.copy(Ee.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ne.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ne.projectionMatrix),Q.projectionMatrixInverse.copy(ne.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=qr*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(Q){c=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(k)},this.getCameraTexture=function(Q){return p[Q]};let _e=null;function nt(Q,ne){if(u=ne.getViewerPose(l||o),g=ne,u!==null){let Ee=u.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let ze=!1;Ee.length!==k.cameras.length&&(k.cameras.length=0,ze=!0);for(let N=0;N<Ee.length;N++){let dt=Ee[N],$e=null;if(f!==null)$e=f.getViewport(dt);else{let Ue=h.getViewSubImage(d,dt);$e=Ue.viewport,N===0&&(e.setRenderTargetTextures(v,Ue.colorTexture,Ue.depthStencilTexture),e.setRenderTarget(v))}let We=C[N];We===void 0&&(We=new gn,We.layers.enable(N),We.viewport=new $t,C[N]=We),We.matrix.fromArray(dt.transform.matrix),We.matrix.decompose(We.position,We.quaternion,We.scale),We.projectionMatrix.fromArray(dt.projectionMatrix),We.projectionMatrixInverse.copy(We.projectionMatrix).invert(),We.viewport.set($e.x,$e.y,$e.width,$e.height),N===0&&(k.matrix.copy(We.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),ze===!0&&k.cameras.push(We)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=n.getBinding();let N=h.getDepthInformation(Ee[0]);N&&N.isValid&&N.texture&&m.init(N,s.renderState)}if(ve&&ve.includes("camera-access")&&x){e.state.unbindTexture(),h=n.getBinding();for(let N=0;N<Ee.length;N++){let dt=Ee[N].camera;if(dt){let $e=p[dt];$e||($e=new na,p[dt]=$e);let We=h.getCameraImage(dt);$e.sourceTexture=We}}}}for(let Ee=0;Ee<P.length;Ee++){let ze=A[Ee],ve=P[Ee];ze!==null&&ve!==void 0&&ve.update(ze,ne,l||o)}_e&&_e(Q,ne),ne.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ne}),g=null}let Je=new ng;Je.setAnimationLoop(nt),this.setAnimationLoop=function(Q){_e=Q},this.dispose=function(){}}},hr=new Yn,qS=new Pt;function YS(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,od(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,M,S,v){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),x(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?c(m,p,M,S):p.isSpriteMaterial?l(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Un&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Un&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let M=e.get(p),S=M.envMap,v=M.envMapRotation;S&&(m.envMap.value=S,hr.copy(v),hr.x*=-1,hr.y*=-1,hr.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(hr.y*=-1,hr.z*=-1),m.envMapRotation.value.setFromMatrix4(qS.makeRotationFromEuler(hr)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function c(m,p,M,S){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*M,m.scale.value=S*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function l(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,M){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Un&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function x(m,p){let M=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function $S(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function c(M,S){let v=S.program;n.uniformBlockBinding(M,v)}function l(M,S){let v=s[M.id];v===void 0&&(g(M),v=u(M),s[M.id]=v,M.addEventListener("dispose",m));let P=S.program;n.updateUBOMapping(M,P);let A=e.render.frame;r[M.id]!==A&&(d(M),r[M.id]=A)}function u(M){let S=h();M.__bindingPointIndex=S;let v=i.createBuffer(),P=M.__size,A=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,v),i.bufferData(i.UNIFORM_BUFFER,P,A),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,v),v}function h(){for(let M=0;M<a;M++)if(o.indexOf(M)===-1)return o.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){let S=s[M.id],v=M.uniforms,P=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let A=0,D=v.length;A<D;A++){let F=Array.isArray(v[A])?v[A]:[v[A]];for(let T=0,w=F.length;T<w;T++){let C=F[T];if(f(C,A,T,P)===!0){let k=C.__offset,V=Array.isArray(C.value)?C.value:[C.value],W=0;for(let X=0;X<V.length;X++){let q=V[X],j=x(q);typeof q=="number"||typeof q=="boolean"?(C.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,k+W,C.__data)):q.isMatrix3?(C.__data[0]=q.elements[0],C.__data[1]=q.elements[1],C.__data[2]=q.elements[2],C.__data[3]=0,C.__data[4]=q.elements[3],C.__data[5]=q.elements[4],C.__data[6]=q.elements[5],C.__data[7]=0,C.__data[8]=q.elements[6],C.__data[9]=q.elements[7],C.__data[10]=q.elements[8],C.__data[11]=0):(q.toArray(C.__data,W),W+=j.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,k,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(M,S,v,P){let A=M.value,D=S+"_"+v;if(P[D]===void 0)return typeof A=="number"||typeof A=="boolean"?P[D]=A:P[D]=A.clone(),!0;{let F=P[D];if(typeof A=="number"||typeof A=="boolean"){if(F!==A)return P[D]=A,!0}else if(F.equals(A)===!1)return F.copy(A),!0}return!1}function g(M){let S=M.uniforms,v=0,P=16;for(let D=0,F=S.length;D<F;D++){let T=Array.isArray(S[D])?S[D]:[S[D]];for(let w=0,C=T.length;w<C;w++){let k=T[w],V=Array.isArray(k.value)?k.value:[k.value];for(let W=0,X=V.length;W<X;W++){let q=V[W],j=x(q),$=v%P,ae=$%j.boundary,le=$+ae;v+=ae,le!==0&&P-le<j.storage&&(v+=P-le),k.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),k.__offset=v,v+=j.storage}}}let A=v%P;return A>0&&(v+=P-A),M.__size=v,M.__cache={},this}function x(M){let S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function m(M){let S=M.target;S.removeEventListener("dispose",m);let v=o.indexOf(S.__bindingPointIndex);o.splice(v,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function p(){for(let M in s)i.deleteBuffer(s[M]);o=[],s={},r={}}return{bind:c,update:l,dispose:p}}var co=class{constructor(e={}){let{canvas:t=wm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=o;let g=new Uint32Array(4),x=new Int32Array(4),m=null,p=null,M=[],S=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let v=this,P=!1;this._outputColorSpace=vn;let A=0,D=0,F=null,T=-1,w=null,C=new $t,k=new $t,V=null,W=new tt(0),X=0,q=t.width,j=t.height,$=1,ae=null,le=null,xe=new $t(0,0,q,j),Me=new $t(0,0,q,j),_e=!1,nt=new Jr,Je=!1,Q=!1,ne=new Pt,Ee=new O,ze=new $t,ve={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},je=!1;function Ut(){return F===null?$:1}let N=n;function dt(E,H){return t.getContext(E,H)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",pe,!1),t.addEventListener("webglcontextrestored",Ie,!1),t.addEventListener("webglcontextcreationerror",he,!1),N===null){let H="webgl2";if(N=dt(H,E),N===null)throw dt(H)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let $e,We,Ue,St,Pe,Ge,Bt,vt,I,y,U,K,ie,te,Fe,ue,Le,Ce,oe,ge,Be,ke,ye,Ke;function B(){$e=new dM(N),$e.init(),ke=new GS(N,$e),We=new rM(N,$e,e,ke),Ue=new VS(N,$e),We.reversedDepthBuffer&&d&&Ue.buffers.depth.setReversed(!0),St=new mM(N),Pe=new CS,Ge=new HS(N,$e,Ue,Pe,We,ke,St),Bt=new aM(v),vt=new uM(v),I=new bv(N),ye=new iM(N,I),y=new fM(N,I,St,ye),U=new _M(N,y,I,St),oe=new gM(N,We,Ge),ue=new oM(Pe),K=new AS(v,Bt,vt,$e,We,ye,ue),ie=new YS(v,Pe),te=new PS,Fe=new FS($e),Ce=new nM(v,Bt,vt,Ue,U,f,c),Le=new BS(v,U,We),Ke=new $S(N,St,We,Ue),ge=new sM(N,$e,St),Be=new pM(N,$e,St),St.programs=K.programs,v.capabilities=We,v.extensions=$e,v.properties=Pe,v.renderLists=te,v.shadowMap=Le,v.state=Ue,v.info=St}B();let de=new wd(v,N);this.xr=de,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let E=$e.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=$e.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return $},this.setPixelRatio=function(E){E!==void 0&&($=E,this.setSize(q,j,!1))},this.getSize=function(E){return E.set(q,j)},this.setSize=function(E,H,J=!0){if(de.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=E,j=H,t.width=Math.floor(E*$),t.height=Math.floor(H*$),J===!0&&(t.style.width=E+"px",t.style.height=H+"px"),this.setViewport(0,0,E,H)},this.getDrawingBufferSize=function(E){return E.set(q*$,j*$).floor()},this.setDrawingBufferSize=function(E,H,J){q=E,j=H,$=J,t.width=Math.floor(E*J),t.height=Math.floor(H*J),this.setViewport(0,0,E,H)},this.getCurrentViewport=function(E){return E.copy(C)},this.getViewport=function(E){return E.copy(xe)},this.setViewport=function(E,H,J,Z){E.isVector4?xe.set(E.x,E.y,E.z,E.w):xe.set(E,H,J,Z),Ue.viewport(C.copy(xe).multiplyScalar($).round())},this.getScissor=function(E){return E.copy(Me)},this.setScissor=function(E,H,J,Z){E.isVector4?Me.set(E.x,E.y,E.z,E.w):Me.set(E,H,J,Z),Ue.scissor(k.copy(Me).multiplyScalar($).round())},this.getScissorTest=function(){return _e},this.setScissorTest=function(E){Ue.setScissorTest(_e=E)},this.setOpaqueSort=function(E){ae=E},this.setTransparentSort=function(E){le=E},this.getClearColor=function(E){return E.copy(Ce.getClearColor())},this.setClearColor=function(){Ce.setClearColor(...arguments)},this.getClearAlpha=function(){return Ce.getClearAlpha()},this.setClearAlpha=function(){Ce.setClearAlpha(...arguments)},this.clear=function(E=!0,H=!0,J=!0){let Z=0;if(E){let G=!1;if(F!==null){let fe=F.texture.format;G=fe===Sc||fe===Mc||fe===bc}if(G){let fe=F.texture.type,Se=fe===yi||fe===Is||fe===no||fe===so||fe===vc||fe===yc,De=Ce.getClearColor(),Te=Ce.getClearAlpha(),qe=De.r,Ye=De.g,Ve=De.b;Se?(g[0]=qe,g[1]=Ye,g[2]=Ve,g[3]=Te,N.clearBufferuiv(N.COLOR,0,g)):(x[0]=qe,x[1]=Ye,x[2]=Ve,x[3]=Te,N.clearBufferiv(N.COLOR,0,x))}else Z|=N.COLOR_BUFFER_BIT}H&&(Z|=N.DEPTH_BUFFER_BIT),J&&(Z|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),N.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",pe,!1),t.removeEventListener("webglcontextrestored",Ie,!1),t.removeEventListener("webglcontextcreationerror",he,!1),Ce.dispose(),te.dispose(),Fe.dispose(),Pe.dispose(),Bt.dispose(),vt.dispose(),U.dispose(),ye.dispose(),Ke.dispose(),K.dispose(),de.dispose(),de.removeEventListener("sessionstart",Lt),de.removeEventListener("sessionend",zn),On.stop()};function pe(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ie(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let E=St.autoReset,H=Le.enabled,J=Le.autoUpdate,Z=Le.needsUpdate,G=Le.type;B(),St.autoReset=E,Le.enabled=H,Le.autoUpdate=J,Le.needsUpdate=Z,Le.type=G}function he(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function re(E){let H=E.target;H.removeEventListener("dispose",re),Oe(H)}function Oe(E){Qe(E),Pe.remove(E)}function Qe(E){let H=Pe.get(E).programs;H!==void 0&&(H.forEach(function(J){K.releaseProgram(J)}),E.isShaderMaterial&&K.releaseShaderCache(E))}this.renderBufferDirect=function(E,H,J,Z,G,fe){H===null&&(H=ve);let Se=G.isMesh&&G.matrixWorld.determinant()<0,De=Vi(E,H,J,Z,G);Ue.setMaterial(Z,Se);let Te=J.index,qe=1;if(Z.wireframe===!0){if(Te=y.getWireframeAttribute(J),Te===void 0)return;qe=2}let Ye=J.drawRange,Ve=J.attributes.position,rt=Ye.start*qe,mt=(Ye.start+Ye.count)*qe;fe!==null&&(rt=Math.max(rt,fe.start*qe),mt=Math.min(mt,(fe.start+fe.count)*qe)),Te!==null?(rt=Math.max(rt,0),mt=Math.min(mt,Te.count)):Ve!=null&&(rt=Math.max(rt,0),mt=Math.min(mt,Ve.count));let Ft=mt-rt;if(Ft<0||Ft===1/0)return;ye.setup(G,Z,De,J,Te);let wt,it=ge;if(Te!==null&&(wt=I.get(Te),it=Be,it.setIndex(wt)),G.isMesh)Z.wireframe===!0?(Ue.setLineWidth(Z.wireframeLinewidth*Ut()),it.setMode(N.LINES)):it.setMode(N.TRIANGLES);else if(G.isLine){let Xe=Z.linewidth;Xe===void 0&&(Xe=1),Ue.setLineWidth(Xe*Ut()),G.isLineSegments?it.setMode(N.LINES):G.isLineLoop?it.setMode(N.LINE_LOOP):it.setMode(N.LINE_STRIP)}else G.isPoints?it.setMode(N.POINTS):G.isSprite&&it.setMode(N.TRIANGLES);if(G.isBatchedMesh)if(G._multiDrawInstances!==null)Yr("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),it.renderMultiDrawInstances(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount,G._multiDrawInstances);else if($e.get("WEBGL_multi_draw"))it.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let Xe=G._multiDrawStarts,Ot=G._multiDrawCounts,ht=G._multiDrawCount,Sn=Te?I.get(Te).bytesPerElement:1,rs=Pe.get(Z).currentProgram.getUniforms();for(let Cn=0;Cn<ht;Cn++)rs.setValue(N,"_gl_DrawID",Cn),it.render(Xe[Cn]/Sn,Ot[Cn])}else if(G.isInstancedMesh)it.renderInstances(rt,Ft,G.count);else if(J.isInstancedBufferGeometry){let Xe=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ot=Math.min(J.instanceCount,Xe);it.renderInstances(rt,Ft,Ot)}else it.render(rt,Ft)};function At(E,H,J){E.transparent===!0&&E.side===Fi&&E.forceSinglePass===!1?(E.side=Un,E.needsUpdate=!0,Us(E,H,J),E.side=ji,E.needsUpdate=!0,Us(E,H,J),E.side=Fi):Us(E,H,J)}this.compile=function(E,H,J=null){J===null&&(J=E),p=Fe.get(J),p.init(H),S.push(p),J.traverseVisible(function(G){G.isLight&&G.layers.test(H.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),E!==J&&E.traverseVisible(function(G){G.isLight&&G.layers.test(H.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),p.setupLights();let Z=new Set;return E.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let fe=G.material;if(fe)if(Array.isArray(fe))for(let Se=0;Se<fe.length;Se++){let De=fe[Se];At(De,J,G),Z.add(De)}else At(fe,J,G),Z.add(fe)}),p=S.pop(),Z},this.compileAsync=function(E,H,J=null){let Z=this.compile(E,H,J);return new Promise(G=>{function fe(){if(Z.forEach(function(Se){Pe.get(Se).currentProgram.isReady()&&Z.delete(Se)}),Z.size===0){G(E);return}setTimeout(fe,10)}$e.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let pt=null;function _n(E){pt&&pt(E)}function Lt(){On.stop()}function zn(){On.start()}let On=new ng;On.setAnimationLoop(_n),typeof self<"u"&&On.setContext(self),this.setAnimationLoop=function(E){pt=E,de.setAnimationLoop(E),E===null?On.stop():On.start()},de.addEventListener("sessionstart",Lt),de.addEventListener("sessionend",zn),this.render=function(E,H){if(H!==void 0&&H.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),de.enabled===!0&&de.isPresenting===!0&&(de.cameraAutoUpdate===!0&&de.updateCamera(H),H=de.getCamera()),E.isScene===!0&&E.onBeforeRender(v,E,H,F),p=Fe.get(E,S.length),p.init(H),S.push(p),ne.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),nt.setFromProjectionMatrix(ne,_i,H.reversedDepth),Q=this.localClippingEnabled,Je=ue.init(this.clippingPlanes,Q),m=te.get(E,M.length),m.init(),M.push(m),de.enabled===!0&&de.isPresenting===!0){let fe=v.xr.getDepthSensingMesh();fe!==null&&wi(fe,H,-1/0,v.sortObjects)}wi(E,H,0,v.sortObjects),m.finish(),v.sortObjects===!0&&m.sort(ae,le),je=de.enabled===!1||de.isPresenting===!1||de.hasDepthSensing()===!1,je&&Ce.addToRenderList(m,E),this.info.render.frame++,Je===!0&&ue.beginShadows();let J=p.state.shadowsArray;Le.render(J,E,H),Je===!0&&ue.endShadows(),this.info.autoReset===!0&&this.info.reset();let Z=m.opaque,G=m.transmissive;if(p.setupLights(),H.isArrayCamera){let fe=H.cameras;if(G.length>0)for(let Se=0,De=fe.length;Se<De;Se++){let Te=fe[Se];zi(Z,G,E,Te)}je&&Ce.render(E);for(let Se=0,De=fe.length;Se<De;Se++){let Te=fe[Se];An(m,E,Te,Te.viewport)}}else G.length>0&&zi(Z,G,E,H),je&&Ce.render(E),An(m,E,H);F!==null&&D===0&&(Ge.updateMultisampleRenderTarget(F),Ge.updateRenderTargetMipmap(F)),E.isScene===!0&&E.onAfterRender(v,E,H),ye.resetDefaultState(),T=-1,w=null,S.pop(),S.length>0?(p=S[S.length-1],Je===!0&&ue.setGlobalState(v.clippingPlanes,p.state.camera)):p=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function wi(E,H,J,Z){if(E.visible===!1)return;if(E.layers.test(H.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(H);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||nt.intersectsSprite(E)){Z&&ze.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ne);let Se=U.update(E),De=E.material;De.visible&&m.push(E,Se,De,J,ze.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||nt.intersectsObject(E))){let Se=U.update(E),De=E.material;if(Z&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),ze.copy(E.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),ze.copy(Se.boundingSphere.center)),ze.applyMatrix4(E.matrixWorld).applyMatrix4(ne)),Array.isArray(De)){let Te=Se.groups;for(let qe=0,Ye=Te.length;qe<Ye;qe++){let Ve=Te[qe],rt=De[Ve.materialIndex];rt&&rt.visible&&m.push(E,Se,rt,J,ze.z,Ve)}}else De.visible&&m.push(E,Se,De,J,ze.z,null)}}let fe=E.children;for(let Se=0,De=fe.length;Se<De;Se++)wi(fe[Se],H,J,Z)}function An(E,H,J,Z){let G=E.opaque,fe=E.transmissive,Se=E.transparent;p.setupLightsView(J),Je===!0&&ue.setGlobalState(v.clippingPlanes,J),Z&&Ue.viewport(C.copy(Z)),G.length>0&&ui(G,H,J),fe.length>0&&ui(fe,H,J),Se.length>0&&ui(Se,H,J),Ue.buffers.depth.setTest(!0),Ue.buffers.depth.setMask(!0),Ue.buffers.color.setMask(!0),Ue.setPolygonOffset(!1)}function zi(E,H,J,Z){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new Li(1,1,{generateMipmaps:!0,type:$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float")?io:yi,minFilter:Ps,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ft.workingColorSpace}));let fe=p.state.transmissionRenderTarget[Z.id],Se=Z.viewport||C;fe.setSize(Se.z*v.transmissionResolutionScale,Se.w*v.transmissionResolutionScale);let De=v.getRenderTarget(),Te=v.getActiveCubeFace(),qe=v.getActiveMipmapLevel();v.setRenderTarget(fe),v.getClearColor(W),X=v.getClearAlpha(),X<1&&v.setClearColor(16777215,.5),v.clear(),je&&Ce.render(J);let Ye=v.toneMapping;v.toneMapping=ts;let Ve=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),Je===!0&&ue.setGlobalState(v.clippingPlanes,Z),ui(E,J,Z),Ge.updateMultisampleRenderTarget(fe),Ge.updateRenderTargetMipmap(fe),$e.has("WEBGL_multisampled_render_to_texture")===!1){let rt=!1;for(let mt=0,Ft=H.length;mt<Ft;mt++){let wt=H[mt],it=wt.object,Xe=wt.geometry,Ot=wt.material,ht=wt.group;if(Ot.side===Fi&&it.layers.test(Z.layers)){let Sn=Ot.side;Ot.side=Un,Ot.needsUpdate=!0,wo(it,J,Z,Xe,Ot,ht),Ot.side=Sn,Ot.needsUpdate=!0,rt=!0}}rt===!0&&(Ge.updateMultisampleRenderTarget(fe),Ge.updateRenderTargetMipmap(fe))}v.setRenderTarget(De,Te,qe),v.setClearColor(W,X),Ve!==void 0&&(Z.viewport=Ve),v.toneMapping=Ye}function ui(E,H,J){let Z=H.isScene===!0?H.overrideMaterial:null;for(let G=0,fe=E.length;G<fe;G++){let Se=E[G],De=Se.object,Te=Se.geometry,qe=Se.group,Ye=Se.material;Ye.allowOverride===!0&&Z!==null&&(Ye=Z),De.layers.test(J.layers)&&wo(De,H,J,Te,Ye,qe)}}function wo(E,H,J,Z,G,fe){E.onBeforeRender(v,H,J,Z,G,fe),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),G.onBeforeRender(v,H,J,Z,E,fe),G.transparent===!0&&G.side===Fi&&G.forceSinglePass===!1?(G.side=Un,G.needsUpdate=!0,v.renderBufferDirect(J,H,Z,G,E,fe),G.side=ji,G.needsUpdate=!0,v.renderBufferDirect(J,H,Z,G,E,fe),G.side=Fi):v.renderBufferDirect(J,H,Z,G,E,fe),E.onAfterRender(v,H,J,Z,G,fe)}function Us(E,H,J){H.isScene!==!0&&(H=ve);let Z=Pe.get(E),G=p.state.lights,fe=p.state.shadowsArray,Se=G.state.version,De=K.getParameters(E,G.state,fe,H,J),Te=K.getProgramCacheKey(De),qe=Z.programs;Z.environment=E.isMeshStandardMaterial?H.environment:null,Z.fog=H.fog,Z.envMap=(E.isMeshStandardMaterial?vt:Bt).get(E.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&E.envMap===null?H.environmentRotation:E.envMapRotation,qe===void 0&&(E.addEventListener("dispose",re),qe=new Map,Z.programs=qe);let Ye=qe.get(Te);if(Ye!==void 0){if(Z.currentProgram===Ye&&Z.lightsStateVersion===Se)return Ga(E,De),Ye}else De.uniforms=K.getUniforms(E),E.onBeforeCompile(De,v),Ye=K.acquireProgram(De,Te),qe.set(Te,Ye),Z.uniforms=De.uniforms;let Ve=Z.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ve.clippingPlanes=ue.uniform),Ga(E,De),Z.needsLights=Fs(E),Z.lightsStateVersion=Se,Z.needsLights&&(Ve.ambientLightColor.value=G.state.ambient,Ve.lightProbe.value=G.state.probe,Ve.directionalLights.value=G.state.directional,Ve.directionalLightShadows.value=G.state.directionalShadow,Ve.spotLights.value=G.state.spot,Ve.spotLightShadows.value=G.state.spotShadow,Ve.rectAreaLights.value=G.state.rectArea,Ve.ltc_1.value=G.state.rectAreaLTC1,Ve.ltc_2.value=G.state.rectAreaLTC2,Ve.pointLights.value=G.state.point,Ve.pointLightShadows.value=G.state.pointShadow,Ve.hemisphereLights.value=G.state.hemi,Ve.directionalShadowMap.value=G.state.directionalShadowMap,Ve.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Ve.spotShadowMap.value=G.state.spotShadowMap,Ve.spotLightMatrix.value=G.state.spotLightMatrix,Ve.spotLightMap.value=G.state.spotLightMap,Ve.pointShadowMap.value=G.state.pointShadowMap,Ve.pointShadowMatrix.value=G.state.pointShadowMatrix),Z.currentProgram=Ye,Z.uniformsList=null,Ye}function Ha(E){if(E.uniformsList===null){let H=E.currentProgram.getUniforms();E.uniformsList=lo.seqWithValue(H.seq,E.uniforms)}return E.uniformsList}function Ga(E,H){let J=Pe.get(E);J.outputColorSpace=H.outputColorSpace,J.batching=H.batching,J.batchingColor=H.batchingColor,J.instancing=H.instancing,J.instancingColor=H.instancingColor,J.instancingMorph=H.instancingMorph,J.skinning=H.skinning,J.morphTargets=H.morphTargets,J.morphNormals=H.morphNormals,J.morphColors=H.morphColors,J.morphTargetsCount=H.morphTargetsCount,J.numClippingPlanes=H.numClippingPlanes,J.numIntersection=H.numClipIntersection,J.vertexAlphas=H.vertexAlphas,J.vertexTangents=H.vertexTangents,J.toneMapping=H.toneMapping}function Vi(E,H,J,Z,G){H.isScene!==!0&&(H=ve),Ge.resetTextureUnits();let fe=H.fog,Se=Z.isMeshStandardMaterial?H.environment:null,De=F===null?v.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:Zs,Te=(Z.isMeshStandardMaterial?vt:Bt).get(Z.envMap||Se),qe=Z.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,Ye=!!J.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ve=!!J.morphAttributes.position,rt=!!J.morphAttributes.normal,mt=!!J.morphAttributes.color,Ft=ts;Z.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(Ft=v.toneMapping);let wt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,it=wt!==void 0?wt.length:0,Xe=Pe.get(Z),Ot=p.state.lights;if(Je===!0&&(Q===!0||E!==w)){let cn=E===w&&Z.id===T;ue.setState(Z,E,cn)}let ht=!1;Z.version===Xe.__version?(Xe.needsLights&&Xe.lightsStateVersion!==Ot.state.version||Xe.outputColorSpace!==De||G.isBatchedMesh&&Xe.batching===!1||!G.isBatchedMesh&&Xe.batching===!0||G.isBatchedMesh&&Xe.batchingColor===!0&&G.colorTexture===null||G.isBatchedMesh&&Xe.batchingColor===!1&&G.colorTexture!==null||G.isInstancedMesh&&Xe.instancing===!1||!G.isInstancedMesh&&Xe.instancing===!0||G.isSkinnedMesh&&Xe.skinning===!1||!G.isSkinnedMesh&&Xe.skinning===!0||G.isInstancedMesh&&Xe.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Xe.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Xe.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Xe.instancingMorph===!1&&G.morphTexture!==null||Xe.envMap!==Te||Z.fog===!0&&Xe.fog!==fe||Xe.numClippingPlanes!==void 0&&(Xe.numClippingPlanes!==ue.numPlanes||Xe.numIntersection!==ue.numIntersection)||Xe.vertexAlphas!==qe||Xe.vertexTangents!==Ye||Xe.morphTargets!==Ve||Xe.morphNormals!==rt||Xe.morphColors!==mt||Xe.toneMapping!==Ft||Xe.morphTargetsCount!==it)&&(ht=!0):(ht=!0,Xe.__version=Z.version);let Sn=Xe.currentProgram;ht===!0&&(Sn=Us(Z,H,G));let rs=!1,Cn=!1,Os=!1,kt=Sn.getUniforms(),Rn=Xe.uniforms;if(Ue.useProgram(Sn.program)&&(rs=!0,Cn=!0,Os=!0),Z.id!==T&&(T=Z.id,Cn=!0),rs||w!==E){Ue.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),kt.setValue(N,"projectionMatrix",E.projectionMatrix),kt.setValue(N,"viewMatrix",E.matrixWorldInverse);let hn=kt.map.cameraPosition;hn!==void 0&&hn.setValue(N,Ee.setFromMatrixPosition(E.matrixWorld)),We.logarithmicDepthBuffer&&kt.setValue(N,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&kt.setValue(N,"isOrthographic",E.isOrthographicCamera===!0),w!==E&&(w=E,Cn=!0,Os=!0)}if(G.isSkinnedMesh){kt.setOptional(N,G,"bindMatrix"),kt.setOptional(N,G,"bindMatrixInverse");let cn=G.skeleton;cn&&(cn.boneTexture===null&&cn.computeBoneTexture(),kt.setValue(N,"boneTexture",cn.boneTexture,Ge))}G.isBatchedMesh&&(kt.setOptional(N,G,"batchingTexture"),kt.setValue(N,"batchingTexture",G._matricesTexture,Ge),kt.setOptional(N,G,"batchingIdTexture"),kt.setValue(N,"batchingIdTexture",G._indirectTexture,Ge),kt.setOptional(N,G,"batchingColorTexture"),G._colorsTexture!==null&&kt.setValue(N,"batchingColorTexture",G._colorsTexture,Ge));let kn=J.morphAttributes;if((kn.position!==void 0||kn.normal!==void 0||kn.color!==void 0)&&oe.update(G,J,Sn),(Cn||Xe.receiveShadow!==G.receiveShadow)&&(Xe.receiveShadow=G.receiveShadow,kt.setValue(N,"receiveShadow",G.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Rn.envMap.value=Te,Rn.flipEnvMap.value=Te.isCubeTexture&&Te.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&H.environment!==null&&(Rn.envMapIntensity.value=H.environmentIntensity),Cn&&(kt.setValue(N,"toneMappingExposure",v.toneMappingExposure),Xe.needsLights&&Uh(Rn,Os),fe&&Z.fog===!0&&ie.refreshFogUniforms(Rn,fe),ie.refreshMaterialUniforms(Rn,Z,$,j,p.state.transmissionRenderTarget[E.id]),lo.upload(N,Ha(Xe),Rn,Ge)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(lo.upload(N,Ha(Xe),Rn,Ge),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&kt.setValue(N,"center",G.center),kt.setValue(N,"modelViewMatrix",G.modelViewMatrix),kt.setValue(N,"normalMatrix",G.normalMatrix),kt.setValue(N,"modelMatrix",G.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){let cn=Z.uniformsGroups;for(let hn=0,os=cn.length;hn<os;hn++){let ei=cn[hn];Ke.update(ei,Sn),Ke.bind(ei,Sn)}}return Sn}function Uh(E,H){E.ambientLightColor.needsUpdate=H,E.lightProbe.needsUpdate=H,E.directionalLights.needsUpdate=H,E.directionalLightShadows.needsUpdate=H,E.pointLights.needsUpdate=H,E.pointLightShadows.needsUpdate=H,E.spotLights.needsUpdate=H,E.spotLightShadows.needsUpdate=H,E.rectAreaLights.needsUpdate=H,E.hemisphereLights.needsUpdate=H}function Fs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(E,H,J){let Z=Pe.get(E);Z.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Pe.get(E.texture).__webglTexture=H,Pe.get(E.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:J,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,H){let J=Pe.get(E);J.__webglFramebuffer=H,J.__useDefaultFramebuffer=H===void 0};let Wa=N.createFramebuffer();this.setRenderTarget=function(E,H=0,J=0){F=E,A=H,D=J;let Z=!0,G=null,fe=!1,Se=!1;if(E){let Te=Pe.get(E);if(Te.__useDefaultFramebuffer!==void 0)Ue.bindFramebuffer(N.FRAMEBUFFER,null),Z=!1;else if(Te.__webglFramebuffer===void 0)Ge.setupRenderTarget(E);else if(Te.__hasExternalTextures)Ge.rebindTextures(E,Pe.get(E.texture).__webglTexture,Pe.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Ve=E.depthTexture;if(Te.__boundDepthTexture!==Ve){if(Ve!==null&&Pe.has(Ve)&&(E.width!==Ve.image.width||E.height!==Ve.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Ge.setupDepthRenderbuffer(E)}}let qe=E.texture;(qe.isData3DTexture||qe.isDataArrayTexture||qe.isCompressedArrayTexture)&&(Se=!0);let Ye=Pe.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ye[H])?G=Ye[H][J]:G=Ye[H],fe=!0):E.samples>0&&Ge.useMultisampledRTT(E)===!1?G=Pe.get(E).__webglMultisampledFramebuffer:Array.isArray(Ye)?G=Ye[J]:G=Ye,C.copy(E.viewport),k.copy(E.scissor),V=E.scissorTest}else C.copy(xe).multiplyScalar($).floor(),k.copy(Me).multiplyScalar($).floor(),V=_e;if(J!==0&&(G=Wa),Ue.bindFramebuffer(N.FRAMEBUFFER,G)&&Z&&Ue.drawBuffers(E,G),Ue.viewport(C),Ue.scissor(k),Ue.setScissorTest(V),fe){let Te=Pe.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+H,Te.__webglTexture,J)}else if(Se){let Te=H;for(let qe=0;qe<E.textures.length;qe++){let Ye=Pe.get(E.textures[qe]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+qe,Ye.__webglTexture,J,Te)}}else if(E!==null&&J!==0){let Te=Pe.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Te.__webglTexture,J)}T=-1},this.readRenderTargetPixels=function(E,H,J,Z,G,fe,Se,De=0){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Te=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te){Ue.bindFramebuffer(N.FRAMEBUFFER,Te);try{let qe=E.textures[De],Ye=qe.format,Ve=qe.type;if(!We.textureFormatReadable(Ye)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!We.textureTypeReadable(Ve)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=E.width-Z&&J>=0&&J<=E.height-G&&(E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+De),N.readPixels(H,J,Z,G,ke.convert(Ye),ke.convert(Ve),fe))}finally{let qe=F!==null?Pe.get(F).__webglFramebuffer:null;Ue.bindFramebuffer(N.FRAMEBUFFER,qe)}}},this.readRenderTargetPixelsAsync=async function(E,H,J,Z,G,fe,Se,De=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Te=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te)if(H>=0&&H<=E.width-Z&&J>=0&&J<=E.height-G){Ue.bindFramebuffer(N.FRAMEBUFFER,Te);let qe=E.textures[De],Ye=qe.format,Ve=qe.type;if(!We.textureFormatReadable(Ye))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!We.textureTypeReadable(Ve))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let rt=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,rt),N.bufferData(N.PIXEL_PACK_BUFFER,fe.byteLength,N.STREAM_READ),E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+De),N.readPixels(H,J,Z,G,ke.convert(Ye),ke.convert(Ve),0);let mt=F!==null?Pe.get(F).__webglFramebuffer:null;Ue.bindFramebuffer(N.FRAMEBUFFER,mt);let Ft=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await Em(N,Ft,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,rt),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,fe),N.deleteBuffer(rt),N.deleteSync(Ft),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,H=null,J=0){let Z=Math.pow(2,-J),G=Math.floor(E.image.width*Z),fe=Math.floor(E.image.height*Z),Se=H!==null?H.x:0,De=H!==null?H.y:0;Ge.setTexture2D(E,0),N.copyTexSubImage2D(N.TEXTURE_2D,J,0,0,Se,De,G,fe),Ue.unbindTexture()};let Ei=N.createFramebuffer(),tn=N.createFramebuffer();this.copyTextureToTexture=function(E,H,J=null,Z=null,G=0,fe=null){fe===null&&(G!==0?(Yr("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),fe=G,G=0):fe=0);let Se,De,Te,qe,Ye,Ve,rt,mt,Ft,wt=E.isCompressedTexture?E.mipmaps[fe]:E.image;if(J!==null)Se=J.max.x-J.min.x,De=J.max.y-J.min.y,Te=J.isBox3?J.max.z-J.min.z:1,qe=J.min.x,Ye=J.min.y,Ve=J.isBox3?J.min.z:0;else{let kn=Math.pow(2,-G);Se=Math.floor(wt.width*kn),De=Math.floor(wt.height*kn),E.isDataArrayTexture?Te=wt.depth:E.isData3DTexture?Te=Math.floor(wt.depth*kn):Te=1,qe=0,Ye=0,Ve=0}Z!==null?(rt=Z.x,mt=Z.y,Ft=Z.z):(rt=0,mt=0,Ft=0);let it=ke.convert(H.format),Xe=ke.convert(H.type),Ot;H.isData3DTexture?(Ge.setTexture3D(H,0),Ot=N.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Ge.setTexture2DArray(H,0),Ot=N.TEXTURE_2D_ARRAY):(Ge.setTexture2D(H,0),Ot=N.TEXTURE_2D),N.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,H.flipY),N.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),N.pixelStorei(N.UNPACK_ALIGNMENT,H.unpackAlignment);let ht=N.getParameter(N.UNPACK_ROW_LENGTH),Sn=N.getParameter(N.UNPACK_IMAGE_HEIGHT),rs=N.getParameter(N.UNPACK_SKIP_PIXELS),Cn=N.getParameter(N.UNPACK_SKIP_ROWS),Os=N.getParameter(N.UNPACK_SKIP_IMAGES);N.pixelStorei(N.UNPACK_ROW_LENGTH,wt.width),N.pixelStorei(N.UNPACK_IMAGE_HEIGHT,wt.height),N.pixelStorei(N.UNPACK_SKIP_PIXELS,qe),N.pixelStorei(N.UNPACK_SKIP_ROWS,Ye),N.pixelStorei(N.UNPACK_SKIP_IMAGES,Ve);let kt=E.isDataArrayTexture||E.isData3DTexture,Rn=H.isDataArrayTexture||H.isData3DTexture;if(E.isDepthTexture){let kn=Pe.get(E),cn=Pe.get(H),hn=Pe.get(kn.__renderTarget),os=Pe.get(cn.__renderTarget);Ue.bindFramebuffer(N.READ_FRAMEBUFFER,hn.__webglFramebuffer),Ue.bindFramebuffer(N.DRAW_FRAMEBUFFER,os.__webglFramebuffer);for(let ei=0;ei<Te;ei++)kt&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Pe.get(E).__webglTexture,G,Ve+ei),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Pe.get(H).__webglTexture,fe,Ft+ei)),N.blitFramebuffer(qe,Ye,Se,De,rt,mt,Se,De,N.DEPTH_BUFFER_BIT,N.NEAREST);Ue.bindFramebuffer(N.READ_FRAMEBUFFER,null),Ue.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(G!==0||E.isRenderTargetTexture||Pe.has(E)){let kn=Pe.get(E),cn=Pe.get(H);Ue.bindFramebuffer(N.READ_FRAMEBUFFER,Ei),Ue.bindFramebuffer(N.DRAW_FRAMEBUFFER,tn);for(let hn=0;hn<Te;hn++)kt?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,kn.__webglTexture,G,Ve+hn):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,kn.__webglTexture,G),Rn?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,cn.__webglTexture,fe,Ft+hn):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,cn.__webglTexture,fe),G!==0?N.blitFramebuffer(qe,Ye,Se,De,rt,mt,Se,De,N.COLOR_BUFFER_BIT,N.NEAREST):Rn?N.copyTexSubImage3D(Ot,fe,rt,mt,Ft+hn,qe,Ye,Se,De):N.copyTexSubImage2D(Ot,fe,rt,mt,qe,Ye,Se,De);Ue.bindFramebuffer(N.READ_FRAMEBUFFER,null),Ue.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else Rn?E.isDataTexture||E.isData3DTexture?N.texSubImage3D(Ot,fe,rt,mt,Ft,Se,De,Te,it,Xe,wt.data):H.isCompressedArrayTexture?N.compressedTexSubImage3D(Ot,fe,rt,mt,Ft,Se,De,Te,it,wt.data):N.texSubImage3D(Ot,fe,rt,mt,Ft,Se,De,Te,it,Xe,wt):E.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,fe,rt,mt,Se,De,it,Xe,wt.data):E.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,fe,rt,mt,wt.width,wt.height,it,wt.data):N.texSubImage2D(N.TEXTURE_2D,fe,rt,mt,Se,De,it,Xe,wt);N.pixelStorei(N.UNPACK_ROW_LENGTH,ht),N.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Sn),N.pixelStorei(N.UNPACK_SKIP_PIXELS,rs),N.pixelStorei(N.UNPACK_SKIP_ROWS,Cn),N.pixelStorei(N.UNPACK_SKIP_IMAGES,Os),fe===0&&H.generateMipmaps&&N.generateMipmap(Ot),Ue.unbindTexture()},this.initRenderTarget=function(E){Pe.get(E).__webglFramebuffer===void 0&&Ge.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ge.setTextureCube(E,0):E.isData3DTexture?Ge.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ge.setTexture2DArray(E,0):Ge.setTexture2D(E,0),Ue.unbindTexture()},this.resetState=function(){A=0,D=0,F=null,Ue.reset(),ye.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ft._getDrawingBufferColorSpace(e),t.unpackColorSpace=ft._getUnpackColorSpace()}};var ag={type:"change"},Ad={type:"start"},cg={type:"end"},ih=new Ms,lg=new ri,ZS=Math.cos(70*Ra.DEG2RAD),on=new O,Bn=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Td=1e-6,sh=class extends Ma{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Cs.ROTATE,MIDDLE:Cs.DOLLY,RIGHT:Cs.PAN},this.touches={ONE:Rs.ROTATE,TWO:Rs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new yn,this._lastTargetPosition=new O,this._quat=new yn().setFromUnitVectors(e.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new to,this._sphericalDelta=new to,this._scale=1,this._panOffset=new O,this._rotateStart=new be,this._rotateEnd=new be,this._rotateDelta=new be,this._panStart=new be,this._panEnd=new be,this._panDelta=new be,this._dollyStart=new be,this._dollyEnd=new be,this._dollyDelta=new be,this._dollyDirection=new O,this._mouse=new be,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=JS.bind(this),this._onPointerDown=KS.bind(this),this._onPointerUp=jS.bind(this),this._onContextMenu=rw.bind(this),this._onMouseWheel=tw.bind(this),this._onKeyDown=nw.bind(this),this._onTouchStart=iw.bind(this),this._onTouchMove=sw.bind(this),this._onMouseDown=QS.bind(this),this._onMouseMove=ew.bind(this),this._interceptControlDown=ow.bind(this),this._interceptControlUp=aw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ag),this.update(),this.state=It.NONE}update(e=null){let t=this.object.position;on.copy(t).sub(this.target),on.applyQuaternion(this._quat),this._spherical.setFromVector3(on),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Bn:n>Math.PI&&(n-=Bn),s<-Math.PI?s+=Bn:s>Math.PI&&(s-=Bn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(on.setFromSpherical(this._spherical),on.applyQuaternion(this._quatInverse),t.copy(this.target).add(on),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=on.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new O(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=on.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ih.origin.copy(this.object.position),ih.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ih.direction))<ZS?this.object.lookAt(this.target):(lg.setFromNormalAndCoplanarPoint(this.object.up,this.target),ih.intersectPlane(lg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Td||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Td||this._lastTargetPosition.distanceToSquared(this.target)>Td?(this.dispatchEvent(ag),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Bn/60*this.autoRotateSpeed*e:Bn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){on.setFromMatrixColumn(t,0),on.multiplyScalar(-e),this._panOffset.add(on)}_panUp(e,t){this.screenSpacePanning===!0?on.setFromMatrixColumn(t,1):(on.setFromMatrixColumn(t,0),on.crossVectors(this.object.up,on)),on.multiplyScalar(e),this._panOffset.add(on)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;on.copy(s).sub(this.target);let r=on.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Bn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Bn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Bn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Bn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Bn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Bn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Bn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Bn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new be,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function KS(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function JS(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function jS(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(cg),this.state=It.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function QS(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Cs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case Cs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case Cs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Ad)}function ew(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function tw(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(Ad),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(cg))}function nw(i){this.enabled!==!1&&this._handleKeyDown(i)}function iw(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Rs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case Rs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case Rs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case Rs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Ad)}function sw(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function rw(i){this.enabled!==!1&&i.preventDefault()}function ow(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function aw(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function hg(i){let e=[...i].sort((s,r)=>s[0]-r[0]||s[1]-r[1]),t=(s,r,o)=>(r[0]-s[0])*(o[1]-s[1])-(r[1]-s[1])*(o[0]-s[0])>1e-12,n=s=>{let r=[];for(let o of s){for(;r.length>=2&&!t(r[r.length-2],r[r.length-1],o);)r.pop();r.push(o)}return r.slice(0,-1)};return e.length<3?e:[...n(e),...n(e.reverse())]}var lw=24,La={made:.001,support:.002,planned:.003,marks:.004};function Cd(i,e){let t=new Jt;t.setAttribute("position",new nn(new Float32Array(3*i),3));let n=new ea(t,new ws({color:e}));return n.frustumCulled=!1,n.visible=!1,n}function Rd(i,e,t){let n=i.geometry.getAttribute("position");for(let[s,[r,o]]of e.entries())n.setXYZ(s,r,o,t);n.needsUpdate=!0,i.geometry.setDrawRange(0,e.length),i.visible=e.length>2}function Pd(i,e){let t=new Wt(new ia(i,24),new Ni({color:e,depthTest:!1}));return t.renderOrder=2,t.visible=!1,t}var rh=class{constructor(e,t,n){this.sole=e;this.size_m=t;this.colours=n;this.grid=this.makeGrid(),this.support=new Wt(new Jt,new Ni({color:n.support,transparent:!0,opacity:.3,depthTest:!1})),this.support.renderOrder=1,this.support.frustumCulled=!1,this.supportEdge=Cd(8,n.support),this.planned=Array.from({length:4},()=>Cd(4,n.planned));let s=t*.028;this.zmp=Pd(s,n.zmp),this.plannedZmp=Pd(s*.6,n.plannedZmp),this.com=Pd(s*.8,n.com),this.comDrop=new js(new Jt().setFromPoints([new O,new O(0,0,1)]),new ws({color:n.com})),this.comDrop.visible=!1,this.group.add(this.grid,this.support,this.supportEdge,...this.planned,this.zmp,this.plannedZmp,this.com,this.comDrop)}group=new Nn;grid;support;supportEdge;planned;made=[];zmp;plannedZmp;com;comDrop;stood=[!1,!1];setColours(e){this.colours=e,this.group.remove(this.grid),this.grid.dispose(),this.grid=this.makeGrid(),this.group.add(this.grid);let t=(n,s)=>n.material.color.setHex(s);for(let n of this.made)t(n,e.made);for(let n of this.planned)t(n,e.planned);for(let n of[this.support,this.supportEdge])t(n,e.support);t(this.zmp,e.zmp),t(this.plannedZmp,e.plannedZmp);for(let n of[this.com,this.comDrop])t(n,e.com)}show(e,t){let[n=NaN,s=NaN]=e.base_place;if(Number.isNaN(n))return;this.grid.position.set(Math.round(n),Math.round(s),0),this.showSteps(e,n,s),this.showSupport(e,t);let r=(o,a)=>{let[c=NaN,l=NaN]=a;o.visible=!Number.isNaN(c+l),o.visible&&o.position.set(n+c,s+l,La.marks)};r(this.zmp,e.zmp),r(this.plannedZmp,e.planned_zmp),r(this.com,e.com),this.comDrop.visible=this.com.visible&&!Number.isNaN(e.com[2]??NaN),this.comDrop.visible&&(this.comDrop.position.copy(this.com.position),this.comDrop.scale.z=e.com[2]??0)}showSteps(e,t,n){let s=e.footstep_count[0]??0;for(let[r,o]of this.planned.entries()){let[a=0,c=0,l=0]=e.footstep.slice(3*r,3*r+3);o.visible=r<s,o.visible&&Rd(o,this.rectangle(t+a,n+c,l),La.planned)}}showSupport(e,t){let n=[];for(let r of[0,1]){let o=e.contact[r]===1,a=o?t.soleCorners(r).map(({x:c,y:l})=>[c,l]):[];n.push(...a),o&&!this.stood[r]&&this.addMade(a),this.stood[r]=o}let s=hg(n);Rd(this.supportEdge,s,La.support),this.support.visible=s.length>2,this.support.visible&&(this.support.geometry.dispose(),this.support.geometry=new pa(new Qr(s.map(([r,o])=>new be(r,o)))),this.support.position.z=La.support)}addMade(e){let t=this.made.length<lw?Cd(4,this.colours.made):this.made.shift();t&&(this.made.push(t),this.group.add(t),Rd(t,e,La.made))}rectangle(e,t,n){let{length:s,width:r,ahead:o}=this.sole,[a,c]=[Math.cos(n),Math.sin(n)];return[[o+s/2,r/2],[o-s/2,r/2],[o-s/2,-r/2],[o+s/2,-r/2]].map(([u,h])=>[e+a*u-c*h,t+c*u+a*h])}makeGrid(){let e=2*Math.ceil(this.size_m*5),t=new sr(e,e*4,this.colours.grid,this.colours.grid);return t.rotation.x=Math.PI/2,t}};var oh=class{last_ms=-1/0;drawn_ms=[];windowBegan_ms=-1/0;wished=0;drawn=0;goodWindows=0;fineness=1;total=0;isDue(e){return e-this.last_ms>=30}wish(){this.wished+=1}drew(e){for(this.last_ms=e,this.drawn_ms.push(e);(this.drawn_ms[0]??e)<e-1e3;)this.drawn_ms.shift();if(this.drawn+=1,this.total+=1,e-this.windowBegan_ms<2e3)return!1;let n=this.windowBegan_ms>-1/0&&e-this.windowBegan_ms<2*2e3&&this.judge(this.drawn/Math.max(this.wished,1),this.wished*1e3/(e-this.windowBegan_ms));return this.windowBegan_ms=e,this.wished=this.drawn=0,n}get perSecond(){return this.drawn_ms.length}judge(e,t){let n=this.fineness;return this.goodWindows=e>.9?this.goodWindows+1:0,e<.75&&t>20&&(this.fineness=Math.max(this.fineness*.8,.5)),this.goodWindows>=10&&(this.goodWindows=0,this.fineness=Math.min(this.fineness/.8,1)),this.fineness!==n}};var ah=class{constructor(e,t){this.size_m=e;this.most_N=t;let n=e*.012;this.shaft=new Wt(new Es(n,n,1,12).translate(0,.5,0).rotateX(Math.PI/2),this.material),this.head=new Wt(new sa(n*3,n*8,16).rotateX(Math.PI/2),this.material),this.shaft.renderOrder=this.head.renderOrder=3,this.group.add(this.shaft,this.head),this.group.visible=!1}group=new Nn;shaft;head;material=new Ni({depthTest:!1,depthWrite:!1,transparent:!0,opacity:.9});grip;set colour(e){this.material.color.setHex(e)}show(e,[t,n]){let s=Math.hypot(t,n),r=this.size_m*(.12+.88*s/this.most_N);this.shaft.scale.z=r,this.head.position.z=r,this.group.quaternion.setFromUnitVectors(new O(0,0,1),new O(t,n,0).normalize()),this.group.visible=!0,this.grip=e,this.follow()}hide(){this.group.visible=!1,this.grip=void 0}follow(){this.grip&&(this.grip.group.updateWorldMatrix(!0,!1),this.group.position.copy(this.grip.place).applyMatrix4(this.grip.group.matrixWorld))}};var lh=class extends tr{constructor(e){super(e)}load(e,t,n,s){let r=this,o=new xa(this.manager);o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(c){s?s(c):console.error(c),r.manager.itemError(e)}},n,s)}parse(e){function t(l){let u=new DataView(l),h=32/8*3+32/8*3*3+16/8,d=u.getUint32(80,!0);if(80+32/8+d*h===u.byteLength)return!0;let g=[115,111,108,105,100];for(let x=0;x<5;x++)if(n(g,u,x))return!1;return!0}function n(l,u,h){for(let d=0,f=l.length;d<f;d++)if(l[d]!==u.getUint8(h+d))return!1;return!0}function s(l){let u=new DataView(l),h=u.getUint32(80,!0),d,f,g,x=!1,m,p,M,S,v;for(let C=0;C<70;C++)u.getUint32(C,!1)==1129270351&&u.getUint8(C+4)==82&&u.getUint8(C+5)==61&&(x=!0,m=new Float32Array(h*3*3),p=u.getUint8(C+6)/255,M=u.getUint8(C+7)/255,S=u.getUint8(C+8)/255,v=u.getUint8(C+9)/255);let P=84,A=50,D=new Jt,F=new Float32Array(h*3*3),T=new Float32Array(h*3*3),w=new tt;for(let C=0;C<h;C++){let k=P+C*A,V=u.getFloat32(k,!0),W=u.getFloat32(k+4,!0),X=u.getFloat32(k+8,!0);if(x){let q=u.getUint16(k+48,!0);(q&32768)===0?(d=(q&31)/31,f=(q>>5&31)/31,g=(q>>10&31)/31):(d=p,f=M,g=S)}for(let q=1;q<=3;q++){let j=k+q*12,$=C*3*3+(q-1)*3;F[$]=u.getFloat32(j,!0),F[$+1]=u.getFloat32(j+4,!0),F[$+2]=u.getFloat32(j+8,!0),T[$]=V,T[$+1]=W,T[$+2]=X,x&&(w.setRGB(d,f,g,vn),m[$]=w.r,m[$+1]=w.g,m[$+2]=w.b)}}return D.setAttribute("position",new nn(F,3)),D.setAttribute("normal",new nn(T,3)),x&&(D.setAttribute("color",new nn(m,3)),D.hasColors=!0,D.alpha=v),D}function r(l){let u=new Jt,h=/solid([\s\S]*?)endsolid/g,d=/facet([\s\S]*?)endfacet/g,f=/solid\s(.+)/,g=0,x=/[\s]+([+-]?(?:\d*)(?:\.\d*)?(?:[eE][+-]?\d+)?)/.source,m=new RegExp("vertex"+x+x+x,"g"),p=new RegExp("normal"+x+x+x,"g"),M=[],S=[],v=[],P=new O,A,D=0,F=0,T=0;for(;(A=h.exec(l))!==null;){F=T;let w=A[0],C=(A=f.exec(w))!==null?A[1]:"";for(v.push(C);(A=d.exec(w))!==null;){let W=0,X=0,q=A[0];for(;(A=p.exec(q))!==null;)P.x=parseFloat(A[1]),P.y=parseFloat(A[2]),P.z=parseFloat(A[3]),X++;for(;(A=m.exec(q))!==null;)M.push(parseFloat(A[1]),parseFloat(A[2]),parseFloat(A[3])),S.push(P.x,P.y,P.z),W++,T++;X!==1&&console.error("THREE.STLLoader: Something isn't right with the normal of face number "+g),W!==3&&console.error("THREE.STLLoader: Something isn't right with the vertices of face number "+g),g++}let k=F,V=T-F;u.userData.groupNames=v,u.addGroup(k,V,D),D++}return u.setAttribute("position",new Tt(M,3)),u.setAttribute("normal",new Tt(S,3)),u}function o(l){return typeof l!="string"?new TextDecoder().decode(l):l}function a(l){if(typeof l=="string"){let u=new Uint8Array(l.length);for(let h=0;h<l.length;h++)u[h]=l.charCodeAt(h)&255;return u.buffer||u}else return l}let c=a(e);return t(c)?s(c):r(o(e))}};function ug(i,{place:e,turn:t}){i.position.fromArray(e),i.quaternion.fromArray(t)}function cw({kind:i,size:e}){return i==="sphere"?new ma(e[0]/2,20,14):i==="cylinder"?new Es(e[0]/2,e[0]/2,e[2],24).rotateX(Math.PI/2):new Ss(...e)}async function hw(i,e){let t=await fetch(i.mesh?.slice(1)??"",Wi(e));if(!t.ok)throw new Error(await t.text());let n=new lh().parse(await t.arrayBuffer()),s=i.scale??[1,1,1],r=i.centre??[0,0,0];return n.scale(...s).translate(-r[0],-r[1],-r[2]),n.computeVertexNormals(),n}var uo=class{constructor(e){this.description=e;this.links=e.links.map(()=>new Nn),this.base.add(this.links[0]??new Nn);for(let t of e.joints){let n=this.links[t.child];n&&(ug(n,t),this.links[t.parent]?.add(n),this.turning.push({group:n,rest:n.quaternion.clone(),axis:new O(...t.axis)}))}this.pose(e.joints.map(({home:t})=>t));for(let[t,{shapes:n}]of e.links.entries())for(let s of n)this.links[t]?.add(this.solid(s,cw(s)))}base=new Nn;links;turning=[];materials=new Map;spin=new yn;async loadMeshes(e,t){let n=[];for(let[s,{shapes:r}]of this.description.links.entries())for(let[o,a]of r.entries()){let c=this.links[s]?.children.filter(l=>l instanceof Wt)[o];!(c instanceof Wt)||a.mesh===void 0||n.push(hw(a,e).then(l=>{c.geometry.dispose(),c.geometry=l,t()}))}await Promise.all(n)}pose(e){for(let[t,{group:n,rest:s,axis:r}]of this.turning.entries()){let o=e[t];o===void 0||Number.isNaN(o)||n.quaternion.copy(s).multiply(this.spin.setFromAxisAngle(r,o))}}gripAt(e){this.base.updateWorldMatrix(!1,!0);for(let{object:t,point:n}of e.intersectObject(this.base,!0)){let s=this.links.findIndex(o=>o===t.parent),r=this.links[s];if(r)return{link:s,group:r,place:r.worldToLocal(n.clone())}}}gripOn(e){let t=this.links[e],n=t?.children.find(s=>s instanceof Wt);return t&&{link:e,group:t,place:n?.position.clone()??new O}}solePose(e){let{link:t,place:n,turn:s}=this.description.soles[e],r=new Pt().compose(new O(...n),new yn(...s),new O(1,1,1)),o=this.links[t];return o?(o.updateWorldMatrix(!0,!1),r.premultiply(o.matrixWorld)):r}soleCorners(e){let{size:t,centre:n}=this.description.soles[e],s=this.solePose(e);return[[1,1],[-1,1],[-1,-1],[1,-1]].map(([o,a])=>new O(n[0]+o*t[0]/2,n[1]+a*t[1]/2,0).applyMatrix4(s))}setOld(e){for(let t of this.materials.values())t.transparent=e,t.opacity=e?.35:1,t.needsUpdate=!0}solid(e,t){let n=e.rgba.join(),s=this.materials.get(n);if(!s){let[o,a,c]=e.rgba;s=new ga({color:new tt().setRGB(o,a,c,vn)}),this.materials.set(n,s)}let r=new Wt(t,s);return ug(r,e),r}};var dg={light:{sky:15265266,ground:14541801,grid:12831958,made:9082790,planned:1533634,support:1804875,zmp:13708332,plannedZmp:1533634,com:11561472,push:8006614},dark:{sky:1185565,ground:1514788,grid:2765629,made:6122362,planned:6533375,support:3523194,zmp:16739166,plannedZmp:6533375,com:16758605,push:12819455}};function uw(){return document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0})===null}function dw(i,e){let t=i.getContext("webgl2",{alpha:!1,antialias:e,stencil:!1,powerPreference:"low-power"});if(!t)throw new Error("this browser draws no WebGL 2");return t}var ch=class{constructor(e,t){this.canvas=e;this.size_m=t.hip_height*2,this.software=uw(),this.renderer=new co({canvas:e,context:dw(e,!this.software)}),this.body=new uo(t);let[n]=t.soles;this.ground=new rh({length:n.size[0],width:n.size[1],ahead:n.centre[0]},this.size_m,dg.light),this.arrow=new ah(this.size_m,t.bounds.push?.most??1),this.scene.fog=this.fog,this.scene.add(this.body.base,this.ground.group,this.arrow.group,new nr(16777215,8952234,2));let s=new ir(16777215,2.2);s.position.set(1.5,2,4),this.scene.add(s),this.camera.up.set(0,0,1),this.controls=new sh(this.camera,e),this.controls.maxPolarAngle=Math.PI*.53,this.controls.minDistance=this.size_m*.6,this.controls.maxDistance=this.size_m*20,this.controls.addEventListener("change",()=>this.ask()),this.body.base.position.z=t.hip_height,this.followed.set(0,0,this.size_m*.56),this.lookFrom("behind"),new ResizeObserver(()=>this.resize()).observe(e);let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>this.paint(r.matches)),this.paint(r.matches)}body;pace=new oh;software;renderer;scene=new Js;fog=new Qo(0);camera=new gn(38,1,.02,200);controls;ground;arrow;size_m;followed=new O;pending=!0;old=!1;asked=!1;follows=!0;onDrawn=()=>{};show(e){let[t=NaN,n=NaN]=e.base_place,s=e.base_height[0]??NaN;if(!Number.isNaN(t+n+s)){this.body.base.position.set(t,n,s);let[r=0,o=0,a=0,c=1]=e.base_turn;this.body.base.quaternion.set(r,o,a,c).normalize()}this.body.pose(e.joint),this.ground.show(e,this.body),this.arrow.follow(),this.follows&&this.follow(),this.pace.wish(),this.ask()}setOld(e){e!==this.old&&(this.old=e,this.body.setOld(e),this.ask())}lookFrom(e){let t=this.size_m*2.5,n={behind:[-.78*t,-.52*t,.42*t],front:[t,.15*t,.25*t],side:[0,-t,.2*t],top:[-.02*t,0,1.2*t]};this.controls.target.copy(this.followed),this.camera.position.copy(this.followed).add(new O(...n[e])),this.controls.update(),this.ask()}zoom(e){let t=this.camera.position.clone().sub(this.controls.target);t.setLength(Ra.clamp(t.length()*e,this.controls.minDistance,this.controls.maxDistance)),this.camera.position.copy(this.controls.target).add(t),this.controls.update(),this.ask()}gripAt(e,t){let{left:n,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new ba;return a.setFromCamera(new be(2*(e-n)/r-1,1-2*(t-s)/o),this.camera),this.body.gripAt(a)}gripOn(e){return this.body.gripOn(e)}away(){let e=this.camera.getWorldDirection(new O);Math.hypot(e.x,e.y)<.2&&e.set(0,1,0).applyQuaternion(this.camera.quaternion);let t=Math.hypot(e.x,e.y);return[e.x/t,e.y/t]}showPush(e,t){this.arrow.show(e,t),this.ask()}hidePush(){this.arrow.hide(),this.ask()}ask(){this.pending=!0,!(this.asked||document.hidden)&&(this.asked=!0,requestAnimationFrame(e=>this.draw(e)))}draw(e){if(this.asked=!1,!!this.pending){if(!this.pace.isDue(e)){this.ask();return}this.pending=!1,this.haze(),this.renderer.render(this.scene,this.camera),this.pace.drew(e)&&this.resize(),this.onDrawn()}}haze(){let e=this.camera.position.distanceTo(this.controls.target);this.fog.near=e+this.size_m,this.fog.far=e+Math.max(6.5*this.size_m,e)}follow(){let{x:e,y:t}=this.body.base.position,n=new O(e-this.followed.x,t-this.followed.y,0);this.followed.add(n),this.controls.target.add(n),this.camera.position.add(n),this.camera.updateMatrixWorld()}paint(e){let t=dg[e?"dark":"light"];this.scene.background=new tt(t.sky),this.fog.color.set(t.sky),this.ground.setColours(t),this.arrow.colour=t.push,this.ask()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setPixelRatio(Math.min(devicePixelRatio,this.software?1:2)*this.pace.fineness),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.ask())}};var hh=class{constructor(e){this.context=e;let{attempt:t,command:n}=e;lt(_t("robot-name"),e.description.name),document.title=`${e.description.name} – Gaitway`,this.take.addEventListener("click",()=>void t("Take the command",()=>n.take())),this.give.addEventListener("click",()=>void t("Give the command back",()=>n.giveBack()))}lamp=_t("link");lampText=_t("link-text");activity=_t("activity");commander=_t("commander");old=_t("old");take=_t("take");give=_t("give");canvas=_t("scene");look(e){let{freshness:t}=this.context,n=t.state(e);this.lamp.className=`lamp ${n}`,lt(this.lampText,this.linkText(e)),this.old.hidden=n==="live",n!=="live"&&lt(this.old,this.oldText(e));let s=n==="lost"?void 0:t.newest;s?this.showFrame(s):this.showNothing(),this.showCommand(s)}linkText(e){let{freshness:t}=this.context,n=ii(t.pictureAge_ms(e));return t.state(e)==="live"?`live, ${n}`:t.state(e)==="old"?`old, ${n}`:"no connection"}oldText(e){let{freshness:t}=this.context;if(!t.newest)return"Nothing has come from the robot yet.";if(t.state(e)==="lost")return`Connection lost: the picture is ${ii(t.sinceCame_ms(e))} old. Trying again…`;let n=tl.filter((s,r)=>r!==3&&t.age_ms(r,e)>300);return`Old, ${ii(t.pictureAge_ms(e))}: ${n.join(", ")}.`}showNothing(){lt(this.activity,""),this.activity.classList.remove("alarm","caution"),this.canvas.setAttribute("aria-label","The robot, as it was last seen")}showFrame(e){let t=e.mode[0]??NaN,n=Qf[e.activity[0]??0]??"",s=t===ds.batches?n:`${tp[t]??"state not known"}, ${n}`;lt(this.activity,s),this.activity.classList.toggle("alarm",t===ds.emergencyStop||(e.activity[0]??0)>=4),this.activity.classList.toggle("caution",t===ds.safeTail);let r=Math.hypot(e.velocity[0]??0,e.velocity[1]??0);this.canvas.setAttribute("aria-label",`The robot ${s}${r>.03?`, ${r.toFixed(1)} m/s`:""}`)}showCommand(e){let{command:t,robot:n}=this.context,s=e?el(e):"",r=!t.mine&&s!=="";lt(this.commander,t.mine?"you command":r?`${s} commands`:e?"nobody commands":""),this.commander.classList.toggle("mine",t.mine),this.take.hidden=t.mine,this.take.disabled=r||!n.isOpen,this.give.hidden=!t.mine}};function fg(i,e){i.addEventListener("pointerdown",t=>t.button===0&&e()),i.addEventListener("click",e)}var uh=class{constructor(e,t){this.context=e;this.ended=t;fg(this.stopButton,()=>this.stop()),fg(this.emergencyButton,()=>this.emergencyStop()),this.releaseButton.addEventListener("click",()=>this.release()),document.addEventListener("keydown",n=>this.key(n),{capture:!0}),document.addEventListener("keyup",n=>n.code==="Space"&&!Po(n.target)&&n.preventDefault(),{capture:!0})}stopButton=_t("stop");emergencyButton=_t("emergency");releaseButton=_t("release");stop(){this.ended(),this.context.attempt("Stop",()=>this.context.robot.stop("/stop"))}show(e){let t=e.mode[0]===ds.emergencyStop;this.releaseButton.hidden=!t,this.emergencyButton.setAttribute("aria-pressed",String(t))}emergencyStop(){this.ended(),this.context.attempt("Emergency stop",()=>this.context.robot.stop("/emergency_stop",{data:!1}))}release(){let{attempt:e,command:t,robot:n}=this.context;e("Release",async()=>{t.mine||await t.take(),await n.order("/release")})}key(e){let t=e.code==="Escape"||e.code==="Space"&&!Po(e.target);if(!t||e.repeat){t&&e.preventDefault();return}e.preventDefault(),e.stopPropagation(),this.stop()}};var dh=class{constructor(e,t,n){this.panels=t;for(let[s,r]of n.entries()){let o=`tab-${s}`,a=ee("button",{type:"button",role:"tab",id:o,"aria-controls":`${o}-panel`},r.title);r.content.id=`${o}-panel`,r.content.setAttribute("role","tabpanel"),r.content.setAttribute("aria-labelledby",o),r.content.hidden=!0,a.addEventListener("click",()=>this.open(r)),this.buttons.set(r,a),e.append(a),t.append(r.content)}e.addEventListener("keydown",s=>this.step(s,n)),n[0]&&this.open(n[0])}current;buttons=new Map;look(e){this.current?.look?.(e)}open(e){if(e!==this.current){this.current?.hide?.(),this.current=e;for(let[t,n]of this.buttons){let s=t===e;n.setAttribute("aria-selected",String(s)),n.tabIndex=s?0:-1,t.content.hidden=!s}this.buttons.get(e)?.scrollIntoView({inline:"nearest",block:"nearest"}),this.panels.scrollTop=0,e.show?.(),e.look?.(performance.now())}}step(e,t){let s={ArrowRight:1,ArrowLeft:-1}[e.key];if(s===void 0||!this.current)return;e.preventDefault(),e.stopPropagation();let r=t[(t.indexOf(this.current)+s+t.length)%t.length];r&&(this.open(r),this.buttons.get(r)?.focus())}};async function pg(i,e){let t=await fetch(i,Wi(e));if(!t.ok)throw new Error(await t.text());return t.json()}var mg=i=>pg("motions.json",i),gg=(i,e)=>pg(i,e),fw=.8;function _g(i,{period:e,postures:t}){let n=(t.length-1)*e;return Math.min(i%(n+fw),n)}function xg({period:i,postures:e},t){let n=Math.min(Math.max(t/i,0),e.length-1),s=e[Math.floor(n)],r=e[Math.ceil(n)];if(!s||!r)throw new RangeError("a motion has no postures");let o=(a,c)=>a.map((l,u)=>l+((c[u]??l)-l)*(n-Math.floor(n)));return{joints:o(s.joints,r.joints),feet:[o(s.feet[0],r.feet[0]),o(s.feet[1],r.feet[1])],support:s.support}}function fh({description:i,duration:e,start:t,refused:n}){if(n!==void 0)return`No preview: ${n}.`;let s=t!=="stands"?" On the ground it is drawn roughly.":"";return`${i??""} ${(e??0).toFixed(1)} s; begins when the robot ${t}.${s}`.trim()}function vg({period:i,postures:e},t){let n=e.findIndex(({support:s})=>s!==3);return n<0?0:Math.min(Math.max(t/Math.max(n*i,i),0),1)}var pw=8368874,mw=50,gw={"lies on its front":[0,Math.PI/2],"lies on its back":[0,-Math.PI/2],"lies on its left":[-Math.PI/2,0],"lies on its right":[Math.PI/2,0]},Ld=class{constructor(e,t){this.canvas=e;let{description:n}=t;this.renderer=new co({canvas:e,antialias:!0,alpha:!0,powerPreference:"low-power"}),this.body=new uo(n),this.tint();let s=n.hip_height*2,r=new sr(s*1.2,8,9082790,9082790);r.rotation.x=Math.PI/2;let o=new ir(16777215,2.2);o.position.set(1.5,2,4),this.scene.add(this.body.base,r,new nr(16777215,8952234,2.4),o),this.camera.up.set(0,0,1),this.camera.position.set(2*s,1.35*s,.9*s),this.camera.lookAt(0,0,s*.52),this.body.loadMeshes(t.token(),()=>{}).catch(()=>{})}renderer;scene=new Js;camera=new gn(32,1,.05,50);body;box=new Di;tint(){this.body.base.traverse(e=>{e instanceof Wt&&e.material.color.set(pw)})}draw(e,t,n){this.body.pose(e.joints),e.support===3?this.layDown(t,n):this.stand(e);let{clientWidth:s,clientHeight:r}=this.canvas;this.renderer.setSize(s,r,!1),this.camera.aspect=s/Math.max(r,1),this.camera.updateProjectionMatrix(),this.renderer.render(this.scene,this.camera)}stand({feet:e,support:t}){let n=t===1?1:0,[s,r,o,a]=e[n],c=new Pt().makeRotationZ(a).setPosition(s,r,o),{base:l}=this.body;l.position.set(0,0,0),l.quaternion.identity(),l.updateMatrixWorld(!0),c.multiply(this.body.solePose(n).invert()).decompose(l.position,l.quaternion,l.scale)}layDown(e,t){let{base:n}=this.body,[s,r]=gw[e]??[0,Math.PI/2];n.quaternion.setFromEuler(new Yn(s,r,0)).slerp(new yn,t*t),n.position.set(0,0,0),this.box.setFromObject(n),n.position.set(-(this.box.min.x+this.box.max.x)/2,0,-this.box.min.z)}},ph=class{constructor(e){this.context=e}canvas=ee("canvas",{role:"img","aria-label":"Ghost of the robot that plays a motion"});title=ee("strong");text=ee("span");figure=ee("figure",{class:"preview",hidden:!0},this.canvas,ee("figcaption",{role:"status"},this.title," ",this.text,ee("small",{},"A preview: the robot does not move.")));known=new Map;picture;shown;get name(){return this.shown?.name}async show(e){if(this.shown!==e&&(this.shown=e,this.figure.hidden=!1,this.canvas.hidden=e.postures===void 0,lt(this.title,e.name.replaceAll("_"," ")),lt(this.text,fh(e)),e.postures!==void 0))try{let t=await this.posturesOf(e.postures);this.shown===e&&this.play(e,t)}catch(t){this.known.delete(e.postures),this.shown===e&&lt(this.text,`No preview: ${t.message}`)}}hide(){this.shown=void 0,this.figure.hidden=!0}posturesOf(e){let t=this.known.get(e)??gg(e,this.context.token());return this.known.set(e,t),t}play(e,t){this.picture??=new Ld(this.canvas,this.context);let n=performance.now(),s=-1/0,r=o=>{if(this.shown!==e||(requestAnimationFrame(r),o-s<mw||this.canvas.clientWidth===0))return;s=o;let a=_g(Math.max(o-n,0)/1e3,t);this.picture?.draw(xg(t,a),e.start??"",vg(t,a)),this.figure.dataset.time=a.toFixed(2)};requestAnimationFrame(r)}};var yg=i=>i.replaceAll("_"," ");function bg(i,e,...t){let n=new ph(i);_t("picture").append(n.figure);let s,r,o=async f=>{r??=mg(i.token()).then(g=>new Map(g.map(x=>[x.name,x])));try{return(await r).get(f)??{name:f,refused:"it is not prepared: run `gaitway motion prepare`"}}catch(g){return r=void 0,{name:f,refused:g.message}}},a,c=async f=>{a=f;let g=await o(f);a===f&&await n.show(g)},l=()=>{a=void 0,n.hide()},u=f=>{s?.setAttribute("aria-pressed","false"),s=f,s?.setAttribute("aria-pressed","true")},h=()=>s?void c(s.value):l(),d=f=>{let g=Rt(yg(f),()=>e(f)),x=Rt("▷",()=>{u(s===x?void 0:x),h()},{class:"show",value:f,"aria-pressed":"false","aria-label":`Preview ${yg(f)}`,title:"Preview: the robot does not move"});for(let m of[g,x])m.addEventListener("pointerenter",({pointerType:p})=>p==="mouse"&&void c(f)),m.addEventListener("pointerleave",({pointerType:p})=>p==="mouse"&&h()),m.addEventListener("focus",()=>m.matches(":focus-visible")&&void c(f)),m.addEventListener("blur",h);return g.addEventListener("pointerenter",()=>void o(f).then(m=>g.title=fh(m)),{once:!0}),ee("span",{class:"motion"},g,x)};return{group:ee("div",{class:"buttons",role:"group","aria-label":"Motions"},...i.description.motions.map(d),...t),hide:()=>{u(void 0),l()}}}var fo=i=>Number.isNaN(i)?"–":`${i<-.005?"−":""}${Math.abs(i).toFixed(2)}`;function _w(){let i=[],e=["forward, m/s","left, m/s","turn, rad/s"].map(s=>{let r=[0,1,2].map(()=>ee("td",{class:"number"}));return i.push(r),ee("tr",{},ee("th",{scope:"row"},s),...r)}),t=ee("tr",{},ee("td"),...["asked","is","at most"].map(s=>ee("th",{scope:"col"},s)));return{table:ee("table",{class:"speeds"},ee("caption",{class:"hidden"},"Speeds"),ee("thead",{},t),ee("tbody",{},...e)),cells:i}}var xw={rests:"Hold the stick, or W A S D: the robot walks while you hold it.",waits:"Asking for the command…",drives:"Driving. Let go, and it stands.",blocked:"Ended. Let go of the stick first."};function vw(i,e,t){if(e?.mode[0]===ds.emergencyStop)return"The emergency stop holds the robot: it walks once that is released.";if(e?.activity[0]!==ep)return xw[i];let n=t.filter(s=>s.startsWith("get_up")).map(s=>`“${s.replaceAll("_"," ")}”`);return`The robot lies, and walks nowhere. ${n.length>0?`Below are ${n.join(" and ")}: the side that it lies on decides.`:"Lift it up."}`}function Mg(i,e){let{attempt:t,command:n,robot:s,freshness:r,drive:o}=i,{table:a,cells:c}=_w(),l=ee("p",{class:"hint",role:"status"}),u=(m,p,M)=>()=>void t(m,async()=>{n.mine||await n.take(),await p()},M),h=Rt("Stand",u("Stand",()=>s.order("/stand",{},15e3))),d=Rt("Leave the motion",u("Leave the motion",()=>s.order("/play_motion",{motion:""}))),f=bg(i,m=>u(`Motion ${m}`,()=>s.order("/play_motion",{motion:m},15e3),"begun")(),d),g=ee("p",{class:"hint",role:"status"}),x=ee("div",{class:"drive"},ee("div",{class:"sticks"},e.walk.field,ee("div",{class:"beside"},e.side.field,l,h)),a,ee("h2",{},"Motions"),f.group,g);return s.subscribe("/motion_state","gaitway_msgs/msg/MotionState",200,m=>{let p=m.state!=="none";d.disabled=!p;let M=p?`${m.motion}: ${m.state}, ${Number(m.time).toFixed(1)} of ${Number(m.duration).toFixed(1)} s`:"";lt(g,M||(m.result==="none"?"":`${m.motion}: ${m.result}`))}),{title:"Drive",content:x,hide:f.hide,look:()=>{lt(l,vw(o.state,r.newest,i.description.motions));let{forward:m,left:p,turn:M}=e.sent,S=r.newest?.velocity??[],{bounds:v}=e,P=[`${fo(-v.backward)} … ${fo(v.forward)}`,`± ${fo(v.left)}`,`± ${fo(v.turn)}`];for(let[A,D]of[m,p,M].entries()){let F=[fo(D),fo(S[A]??NaN),P[A]??""];for(let[T,w]of(c[A]??[]).entries())lt(w,F[T]??"")}}}}var Sg=500,yw=[{least:0,name:"all"},{least:30,name:"warnings and errors"},{least:40,name:"errors"}];function bw(i){let e=i.stamp;return{time_s:e.sec+e.nanosec*1e-9,level:Number(i.level),source:String(i.name),text:String(i.msg)}}function Mw(i,e,t){let n=`${i.source} ${i.text}`.toLowerCase();return i.level>=e&&t.toLowerCase().split(/\s+/).every(s=>n.includes(s))}function wg({time_s:i,level:e,source:t,text:n}){let s=e>=40?"error":e>=30?"warning":"info";return ee("li",{class:s},ee("span",{class:"number"},i.toFixed(2))," ",ee("b",{},s==="info"?t:`${s}: ${t}`),` ${n}`)}function Eg({robot:i}){let e=[],t=ee("ol",{class:"events",tabindex:0,"aria-label":"Events, the newest first"}),n=ee("select",{id:"event-level","aria-label":"Which events"},...yw.map(({least:u,name:h})=>ee("option",{value:u},h))),s=ee("input",{type:"search",placeholder:"filter by words","aria-label":"Filter by words"}),r=u=>Mw(u,Number(n.value),s.value),o=ee("p",{class:"hint",role:"status"}),a=()=>lt(o,t.childElementCount>0?"":e.length>0?`None of ${e.length} events passes the filter.`:"No event yet."),c=()=>{t.replaceChildren(...e.filter(r).map(wg)),a()};n.addEventListener("change",c),s.addEventListener("input",c),i.subscribe("/events","rcl_interfaces/msg/Log",0,u=>{let h=bw(u);for(e=[h,...e.slice(0,Sg-1)],r(h)&&t.prepend(wg(h));t.childElementCount>Sg;)t.lastElementChild?.remove();a()}),a();let l=Rt("Clear",()=>{e=[],c()});return{title:"Events",content:ee("div",{class:"events-tab"},ee("div",{class:"tools"},n,s,l),o,t)}}var Sw="uplot",ww="u-hz",Ew="u-vt",Tw="u-title",Aw="u-wrap",Cw="u-under",Rw="u-over",Pw="u-axis",mr="u-off",Iw="u-select",Lw="u-cursor-x",Dw="u-cursor-y",Nw="u-cursor-pt",Uw="u-legend",Fw="u-live",Ow="u-inline",kw="u-series",Bw="u-marker",Tg="u-label",zw="u-value",Na="width",Ua="height";var Ag="bottom",po="left",Dd="right",Kd="#000",Cg=Kd+"0",Nd="mousemove",Rg="mousedown",Ud="mouseup",Pg="mouseenter",Ig="mouseleave",Lg="dblclick",Vw="resize",Hw="scroll",Dg="change",vh="dppxchange",Jd="--",bo=typeof window<"u",zd=bo?document:null,go=bo?window:null,Gw=bo?navigator:null,bt,mh;function Vd(){let i=devicePixelRatio;bt!=i&&(bt=i,mh&&Gd(Dg,mh,Vd),mh=matchMedia(`(min-resolution: ${bt-.001}dppx) and (max-resolution: ${bt+.001}dppx)`),gr(Dg,mh,Vd),go.dispatchEvent(new CustomEvent(vh)))}function Kn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Hd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Xt(i,e,t){i.style[e]=t+"px"}function bi(i,e,t,n){let s=zd.createElement(i);return e!=null&&Kn(s,e),t?.insertBefore(s,n),s}function li(i,e){return bi("div",i,e)}var Ng=new WeakMap;function Bi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Ng.get(i);r!=o&&(i.style.transform=r,Ng.set(i,r),e<0||t<0||e>n||t>s?Kn(i,mr):Hd(i,mr))}var Ug=new WeakMap;function Fg(i,e,t){let n=e+t,s=Ug.get(i);n!=s&&(Ug.set(i,n),i.style.background=e,i.style.borderColor=t)}var Og=new WeakMap;function kg(i,e,t,n){let s=e+""+t,r=Og.get(i);s!=r&&(Og.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var jd={passive:!0},Ww={...jd,capture:!0};function gr(i,e,t,n){e.addEventListener(i,t,n?Ww:jd)}function Gd(i,e,t,n){e.removeEventListener(i,t,jd)}bo&&Vd();function Mi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Jn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function d0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var f0=i=>i!=null,p0=i=>i!=null&&i>0,Mh=d0(f0),Xw=d0(p0);function qw(i,e,t,n=0,s=!1){let r=s?Xw:Mh,o=s?p0:f0;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let u=i[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Dt,c??-Dt]}function Sh(i,e,t,n){let s=Vg(i),r=Vg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?is:m0,a=s==1?Jn:ci,c=r==1?ci:Jn,l=a(o(ln(i))),u=c(o(ln(e))),h=_o(t,l),d=_o(t,u);return t==10&&(l<0&&(h=Nt(h,-l)),u<0&&(d=Nt(d,-u))),n||t==2?(i=h*s,e=d*r):(i=v0(i,h),e=wh(e,d)),[i,e]}function Qd(i,e,t,n){let s=Sh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var ef=.1,Bg={mode:3,pad:ef},Oa={pad:0,soft:null,mode:0},Yw={min:Oa,max:Oa};function yh(i,e,t,n){return Eh(t)?zg(i,e,t):(Oa.pad=t,Oa.soft=n?0:null,Oa.mode=n?3:0,zg(i,e,Yw))}function xt(i,e){return i??e}function $w(i,e,t){for(e=xt(e,0),t=xt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function zg(i,e,t){let n=t.min,s=t.max,r=xt(n.pad,0),o=xt(s.pad,0),a=xt(n.hard,-Dt),c=xt(s.hard,Dt),l=xt(n.soft,Dt),u=xt(s.soft,-Dt),h=xt(n.mode,0),d=xt(s.mode,0),f=e-i,g=is(f),x=Fn(ln(i),ln(e)),m=is(x),p=ln(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,h==2&&l!=Dt&&(r=0),d==2&&u!=-Dt&&(o=0)));let M=f||x||1e3,S=is(M),v=_o(10,Jn(S)),P=M*(f==0?i==0?.1:1:r),A=Nt(v0(i-P,v/10),24),D=i>=l&&(h==1||h==3&&A<=l||h==2&&A>=l)?l:Dt,F=Fn(a,A<D&&i>=D?D:Si(D,A)),T=M*(f==0?e==0?.1:1:o),w=Nt(wh(e+T,v/10),24),C=e<=u&&(d==1||d==3&&w>=u||d==2&&w<=u)?u:-Dt,k=Si(c,w>C&&e<=C?C:Fn(C,w));return F==k&&F==0&&(k=100),[F,k]}var Zw=new Intl.NumberFormat(bo?Gw.language:"en-US"),tf=i=>Zw.format(i),jn=Math,xh=jn.PI,ln=jn.abs,Jn=jn.floor,an=jn.round,ci=jn.ceil,Si=jn.min,Fn=jn.max,_o=jn.pow,Vg=jn.sign,is=jn.log10,m0=jn.log2,Kw=(i,e=1)=>jn.sinh(i)*e,Fd=(i,e=1)=>jn.asinh(i/e),Dt=1/0;function Hg(i){return(is((i^i>>31)-(i>>31))|0)+1}function Wd(i,e,t){return Si(Fn(i,e),t)}function g0(i){return typeof i=="function"}function ut(i){return g0(i)?i:()=>i}var Jw=()=>{},_0=i=>i,x0=(i,e)=>e,jw=i=>null,Gg=i=>!0,Wg=(i,e)=>i==e,Qw=/\.\d*?(?=9{6,}|0{6,})/gm,_r=i=>{if(b0(i)||Ds.has(i))return i;let e=`${i}`,t=e.match(Qw);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${_r(s)}e${r}`}return Nt(i,n)};function fr(i,e){return _r(Nt(_r(i/e))*e)}function wh(i,e){return _r(ci(_r(i/e))*e)}function v0(i,e){return _r(Jn(_r(i/e))*e)}function Nt(i,e=0){if(b0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return an(n)/t}var Ds=new Map;function y0(i){return((""+i).split(".")[1]||"").length}function Ba(i,e,t,n){let s=[],r=n.map(y0);for(let o=e;o<t;o++){let a=ln(o),c=Nt(_o(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+`${n[l]}e${o}`:n[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=i==10?u:Nt(u,h);s.push(d),Ds.set(d,h)}}return s}var ka={},nf=[],xo=[null,null],Ls=Array.isArray,b0=Number.isInteger,eE=i=>i===void 0;function Xg(i){return typeof i=="string"}function Eh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function tE(i){return i!=null&&typeof i=="object"}var nE=Object.getPrototypeOf(Uint8Array),M0="__proto__";function vo(i,e=Eh){let t;if(Ls(i)){let n=i.find(s=>s!=null);if(Ls(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=vo(i[s],e)}else t=i.slice()}else if(i instanceof nE)t=i.slice();else if(e(i)){t={};for(let n in i)n!=M0&&(t[n]=vo(i[n],e))}else t=i;return t}function en(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=M0&&(Eh(i[s])?en(i[s],vo(n[s])):i[s]=vo(n[s]))}return i}var iE=0,sE=1,rE=2;function oE(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function aE(i,e){if(hE(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return uE(o[0])||(o=cE(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)t.add(c[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],h=Array(s).fill(void 0),d=e?e[o][l]:sE,f=[];for(let g=0;g<u.length;g++){let x=u[g],m=r.get(c[g]);x===null?d!=iE&&(h[m]=x,d==rE&&f.push(m)):h[m]=x}oE(h,f,s),n.push(h)}}return n}var lE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function cE(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function hE(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function uE(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Fn(1,Jn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var S0=["January","February","March","April","May","June","July","August","September","October","November","December"],w0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function E0(i){return i.slice(0,3)}var dE=w0.map(E0),fE=S0.map(E0),pE={MMMM:S0,MMM:fE,WWWW:w0,WWW:dE};function Da(i){return(i<10?"0":"")+i}function mE(i){return(i<10?"00":i<100?"0":"")+i}var gE={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Da(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Da(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Da(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Da(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Da(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>mE(i.getMilliseconds())};function sf(i,e){e=e||pE;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?gE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var _E=new Intl.DateTimeFormat().resolvedOptions().timeZone;function xE(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==_E?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var T0=i=>i%1==0,bh=[1,2,2.5,5],vE=Ba(10,-32,0,bh),A0=Ba(10,0,32,bh),yE=A0.filter(T0),pr=vE.concat(A0),rf=`
`,C0="{YYYY}",qg=rf+C0,R0="{M}/{D}",Fa=rf+R0,gh=Fa+"/{YY}",P0="{aa}",bE="{h}:{mm}",mo=bE+P0,Yg=rf+mo,$g=":{ss}",Mt=null;function I0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?Ba(10,0,3,bh).filter(T0):Ba(10,-3,0,bh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,C0,Mt,Mt,Mt,Mt,Mt,Mt,1],[s*28,"{MMM}",qg,Mt,Mt,Mt,Mt,Mt,1],[s,R0,qg,Mt,Mt,Mt,Mt,Mt,1],[n,"{h}"+P0,gh,Mt,Fa,Mt,Mt,Mt,1],[t,mo,gh,Mt,Fa,Mt,Mt,Mt,1],[e,$g,gh+" "+mo,Mt,Fa+" "+mo,Mt,Yg,Mt,1],[i,$g+".{fff}",gh+" "+mo,Mt,Fa+" "+mo,Mt,Yg,Mt,1]];function u(h){return(d,f,g,x,m,p)=>{let M=[],S=m>=o,v=m>=r&&m<o,P=h(g),A=Nt(P*i,3),D=Od(P.getFullYear(),S?0:P.getMonth(),v||S?1:P.getDate()),F=Nt(D*i,3);if(v||S){let T=v?m/r:0,w=S?m/o:0,C=A==F?A:Nt(Od(D.getFullYear()+w,D.getMonth()+T,1)*i,3),k=new Date(an(C/i)),V=k.getFullYear(),W=k.getMonth();for(let X=0;C<=x;X++){let q=Od(V+w*X,W+T*X,1),j=q-h(Nt(q*i,3));C=Nt((+q+j)*i,3),C<=x&&M.push(C)}}else{let T=m>=s?s:m,w=Jn(g)-Jn(A),C=F+w+wh(A-F,T);M.push(C);let k=h(C),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,W=m/n,X=d.axes[f]._space,q=p/X;for(;C=Nt(C+m,i==1?0:3),!(C>x);)if(W>1){let j=Jn(Nt(V+W,6))%24,le=h(C).getHours()-j;le>1&&(le=-1),C-=le*n,V=(V+W)%24;let xe=M[M.length-1];Nt((C-xe)/m,3)*q>=.7&&M.push(C)}else M.push(C)}return M}}return[c,l,u]}var[ME,SE,wE]=I0(1),[EE,TE,AE]=I0(.001);Ba(2,-53,53,[1]);function Zg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Kg(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],c,l,u,h,d,f;return n.map(g=>{let x=i(g),m=x.getFullYear(),p=x.getMonth(),M=x.getDate(),S=x.getHours(),v=x.getMinutes(),P=x.getSeconds(),A=m!=c&&a[2]||p!=l&&a[3]||M!=u&&a[4]||S!=h&&a[5]||v!=d&&a[6]||P!=f&&a[7]||a[1];return c=m,l=p,u=M,h=S,d=v,f=P,A(x)})}}function CE(i,e){let t=sf(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Od(i,e,t){return new Date(i,e,t)}function Jg(i,e){return e(i)}var RE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function jg(i,e){return(t,n,s,r)=>r==null?Jd:e(i(n))}function PE(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function IE(i,e){return i.series[e].fill(i,e)}var LE={show:!0,live:!0,isolate:!1,mount:Jw,markers:{show:!0,width:2,stroke:PE,fill:IE,dash:"solid"},idx:null,idxs:null,values:[]};function DE(i,e){let t=i.cursor.points,n=li(),s=t.size(i,e);Xt(n,Na,s),Xt(n,Ua,s);let r=s/-2;Xt(n,"marginLeft",r),Xt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Xt(n,"borderWidth",o),n}function NE(i,e){let t=i.series[e].points;return t._fill||t._stroke}function UE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function FE(i,e){return i.series[e].points.size}var kd=[0,0];function OE(i,e,t){return kd[0]=e,kd[1]=t,kd}function _h(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Bd(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var kE={show:!0,x:!0,y:!0,lock:!1,move:OE,points:{one:!1,show:DE,size:FE,width:0,stroke:UE,fill:NE},bind:{mousedown:_h,mouseup:_h,click:_h,dblclick:_h,mousemove:Bd,mouseleave:Bd,mouseenter:Bd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},L0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},of=en({},L0,{filter:x0}),D0=en({},of,{size:10}),N0=en({},L0,{show:!1}),af='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',U0="bold "+af,F0=1.5,Qg={show:!0,scale:"x",stroke:Kd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U0,side:2,grid:of,ticks:D0,border:N0,font:af,lineGap:F0,rotate:0},BE="Value",zE="Time",e0={show:!0,scale:"x",auto:!1,sorted:1,min:Dt,max:-Dt,idxs:[]};function VE(i,e,t,n,s){return e.map(r=>r==null?"":tf(r))}function HE(i,e,t,n,s,r,o){let a=[],c=Ds.get(s)||0;t=o?t:Nt(wh(t,s),c);for(let l=t;l<=n;l=Nt(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Xd(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?is:m0,u=Jn(l(t));s=_o(c,u),c==10&&(s=pr[Mi(s,pr)]);let h=t,d=s*c;c==10&&(d=pr[Mi(d,pr)]);do a.push(h),h=h+s,c==10&&!Ds.has(h)&&(h=Nt(h,Ds.get(s))),h>=d&&(s=h,d=s*c,c==10&&(d=pr[Mi(d,pr)]));while(h<=n);return a}function GE(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?Xd(i,e,Fn(c,t),n,s):[c],u=n>=0&&t<=0?[0]:[];return(t<-c?Xd(i,e,Fn(c,-n),-t,s):[c]).reverse().map(d=>-d).concat(u,l)}var O0=/./,WE=/[12357]/,XE=/[125]/,t0=/1/,qd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function qE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),h=c(9,o)-u>=l?O0:c(7,o)-u>=l?WE:c(5,o)-u>=l?XE:t0;if(h==t0){let d=ln(c(1,o)-u);if(d<l)return qd(e.slice().reverse(),a.distr,h,ci(l/d)).reverse()}return qd(e,a.distr,h,1)}function YE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=ln(c(1,o)-c(2,o));return l<a?qd(e.slice().reverse(),3,O0,ci(a/l)).reverse():e}function $E(i,e,t,n){return n==null?Jd:e==null?"":tf(e)}var n0={show:!0,scale:"y",stroke:Kd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U0,side:3,grid:of,ticks:D0,border:N0,font:af,lineGap:F0,rotate:0};function ZE(i,e){let t=3+(i||1)*2;return Nt(t*e,3)}function KE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=ln(o-r),c=i.series[e],l=a/(c.points.space*bt);return n[1]-n[0]<=l}var i0={scale:null,auto:!0,sorted:0,min:Dt,max:-Dt},k0=(i,e,t,n,s)=>s,s0={show:!0,auto:!0,sorted:0,gaps:k0,alpha:1,facets:[en({},i0,{scale:"x"}),en({},i0,{scale:"y"})]},r0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:k0,alpha:1,points:{show:KE,filter:null},values:null,min:Dt,max:-Dt,idxs:[],path:null,clip:null};function JE(i,e,t,n,s){return t/10}var B0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},jE=en({},B0,{time:!1,ori:1}),o0={};function z0(i,e){let t=o0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(o0[i]=t)),t}var yo=1,Yd=2;function xr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,x=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,c,l,u,h,m,p,d,f,g,x,Ah,Mo,Rh,H0,W0):t(s,c,l,u,h,p,m,f,d,x,g,Ch,So,hf,G0,X0)}function lf(i,e){let t=0,n=0,s=xt(i.bands,nf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function QE(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ss(i,e,t,n,s,r){return xr(i,e,(o,a,c,l,u,h,d,f,g,x,m)=>{let p=o.pxRound,M=l.dir*(l.ori==0?1:-1),S=l.ori==0?Mo:So,v,P;M==1?(v=t,P=n):(v=n,P=t);let A=p(h(a[v],l,x,f)),D=p(d(c[v],u,m,g)),F=p(h(a[P],l,x,f)),T=p(d(r==1?u.max:u.min,u,m,g)),w=new Path2D(s);return S(w,F,T),S(w,A,T),S(w,A,D),w})}function Th(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Rh:hf,c=t;for(let h=0;h<i.length;h++){let d=i[h];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,n,f,n+r),c=d[1]}}let l=t+s-c,u=10;l>0&&a(o,c,n-u/2,l,n+r+u)}return o}function eT(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function cf(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let h=l,d=l;if(s==1)for(;++l<=n&&e[l]===null;)d=l;else for(;--l>=t&&e[l]===null;)d=l;let f=r(i[h]),g=d==h?f:r(i[d]),x=h-s;f=o<=0&&x>=0&&x<c?r(i[x]):f;let p=d+s;g=o>=0&&p>=0&&p<c?r(i[p]):g,g>=f&&a.push([f,g])}return a}function a0(i){return i==0?_0:i==1?an:e=>fr(e,i)}function V0(i){let e=i==0?Ah:Ch,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?n(s,r,o,a,c):(l=Si(l,a/2,c/2),u=Si(u,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,u),t(s,r,o+c,r,o,u),t(s,r,o,r+a,o,l),s.closePath())}}var Ah=(i,e,t)=>{i.moveTo(e,t)},Ch=(i,e,t)=>{i.moveTo(t,e)},Mo=(i,e,t)=>{i.lineTo(e,t)},So=(i,e,t)=>{i.lineTo(t,e)},Rh=V0(0),hf=V0(1),H0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},G0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},W0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},X0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function q0(i){return(e,t,n,s,r)=>xr(e,t,(o,a,c,l,u,h,d,f,g,x,m)=>{let{pxRound:p,points:M}=o,S,v;l.ori==0?(S=Ah,v=H0):(S=Ch,v=G0);let P=Nt(M.width*bt,3),A=(M.size-M.width)/2*bt,D=Nt(A*2,3),F=new Path2D,T=new Path2D,{left:w,top:C,width:k,height:V}=e.bbox;Rh(T,w-D,C-D,k+D*2,V+D*2);let W=X=>{if(c[X]!=null){let q=p(h(a[X],l,x,f)),j=p(d(c[X],u,m,g));S(F,q+A,j),v(F,q,j,A,0,xh*2)}};if(r)r.forEach(W);else for(let X=n;X<=s;X++)W(X);return{stroke:P>0?F:null,fill:F,clip:T,flags:yo|Yd}})}function Y0(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var tT=Y0(Mo),nT=Y0(So);function $0(i){let e=xt(i?.alignGaps,0);return(t,n,s,r)=>xr(t,n,(o,a,c,l,u,h,d,f,g,x,m)=>{[s,r]=Mh(c,s,r);let p=o.pxRound,M=V=>p(h(V,l,x,f)),S=V=>p(d(V,u,m,g)),v,P;l.ori==0?(v=Mo,P=tT):(v=So,P=nT);let A=l.dir*(l.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yo},F=D.stroke,T=!1;if(r-s>=x*4){let V=_e=>t.posToVal(_e,l.key,!0),W=null,X=null,q,j,$,ae=M(a[A==1?s:r]),le=M(a[s]),xe=M(a[r]),Me=V(A==1?le+1:xe-1);for(let _e=A==1?s:r;_e>=s&&_e<=r;_e+=A){let nt=a[_e],Q=(A==1?nt<Me:nt>Me)?ae:M(nt),ne=c[_e];Q==ae?ne!=null?(j=ne,W==null?(v(F,Q,S(j)),q=W=X=j):j<W?W=j:j>X&&(X=j)):ne===null&&(T=!0):(W!=null&&P(F,ae,S(W),S(X),S(q),S(j)),ne!=null?(j=ne,v(F,Q,S(j)),W=X=q=j):(W=X=null,ne===null&&(T=!0)),ae=Q,Me=V(ae+A))}W!=null&&W!=X&&$!=ae&&P(F,ae,S(W),S(X),S(q),S(j))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let W=c[V];W===null?T=!0:W!=null&&v(F,M(a[V]),S(W))}let[C,k]=lf(t,n);if(o.fill!=null||C!=0){let V=D.fill=new Path2D(F),W=o.fillTo(t,n,o.min,o.max,C),X=S(W),q=M(a[s]),j=M(a[r]);A==-1&&([j,q]=[q,j]),v(V,j,X),v(V,q,X)}if(!o.spanGaps){let V=[];T&&V.push(...cf(a,c,s,r,A,M,e)),D.gaps=V=o.gaps(t,n,s,r,V),D.clip=Th(V,l.ori,f,g,x,m)}return k!=0&&(D.band=k==2?[ss(t,n,s,r,F,-1),ss(t,n,s,r,F,1)]:ss(t,n,s,r,F,k)),D})}function iT(i){let e=xt(i.align,1),t=xt(i.ascDesc,!1),n=xt(i.alignGaps,0),s=xt(i.extend,!1);return(r,o,a,c)=>xr(r,o,(l,u,h,d,f,g,x,m,p,M,S)=>{[a,c]=Mh(h,a,c);let v=l.pxRound,{left:P,width:A}=r.bbox,D=le=>v(g(le,d,M,m)),F=le=>v(x(le,f,S,p)),T=d.ori==0?Mo:So,w={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yo},C=w.stroke,k=d.dir*(d.ori==0?1:-1),V=F(h[k==1?a:c]),W=D(u[k==1?a:c]),X=W,q=W;s&&e==-1&&(q=P,T(C,q,V)),T(C,W,V);for(let le=k==1?a:c;le>=a&&le<=c;le+=k){let xe=h[le];if(xe==null)continue;let Me=D(u[le]),_e=F(xe);e==1?T(C,Me,V):T(C,X,_e),T(C,Me,_e),V=_e,X=Me}let j=X;s&&e==1&&(j=P+A,T(C,j,V));let[$,ae]=lf(r,o);if(l.fill!=null||$!=0){let le=w.fill=new Path2D(C),xe=l.fillTo(r,o,l.min,l.max,$),Me=F(xe);T(le,j,Me),T(le,q,Me)}if(!l.spanGaps){let le=[];le.push(...cf(u,h,a,c,k,D,n));let xe=l.width*bt/2,Me=t||e==1?xe:-xe,_e=t||e==-1?-xe:xe;le.forEach(nt=>{nt[0]+=Me,nt[1]+=_e}),w.gaps=le=l.gaps(r,o,a,c,le),w.clip=Th(le,d.ori,m,p,M,S)}return ae!=0&&(w.band=ae==2?[ss(r,o,a,c,C,-1),ss(r,o,a,c,C,1)]:ss(r,o,a,c,C,ae)),w})}function l0(i,e,t,n,s,r,o=Dt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let u=ln(i[c]-i[a]);u<l&&(l=u,o=ln(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function sT(i){i=i||ka;let e=xt(i.size,[.6,Dt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ut(s),o=1-e[0],a=xt(e[1],Dt),c=xt(e[2],1),l=xt(i.disp,ka),u=xt(i.each,f=>{}),{fill:h,stroke:d}=l;return(f,g,x,m)=>xr(f,g,(p,M,S,v,P,A,D,F,T,w,C)=>{let k=p.pxRound,V=t,W=n*bt,X=a*bt,q=c*bt,j,$;v.ori==0?[j,$]=r(f,g):[$,j]=r(f,g);let ae=v.dir*(v.ori==0?1:-1),le=v.ori==0?Rh:hf,xe=v.ori==0?u:(U,K,ie,te,Fe,ue,Le)=>{u(U,K,ie,Fe,te,Le,ue)},Me=xt(f.bands,nf).find(U=>U.series[0]==g),_e=Me!=null?Me.dir:0,nt=p.fillTo(f,g,p.min,p.max,_e),Je=k(D(nt,P,C,T)),Q,ne,Ee,ze=w,ve=k(p.width*bt),je=!1,Ut=null,N=null,dt=null,$e=null;h!=null&&(ve==0||d!=null)&&(je=!0,Ut=h.values(f,g,x,m),N=new Map,new Set(Ut).forEach(U=>{U!=null&&N.set(U,new Path2D)}),ve>0&&(dt=d.values(f,g,x,m),$e=new Map,new Set(dt).forEach(U=>{U!=null&&$e.set(U,new Path2D)})));let{x0:We,size:Ue}=l;if(We!=null&&Ue!=null){V=1,M=We.values(f,g,x,m),We.unit==2&&(M=M.map(ie=>f.posToVal(F+ie*w,v.key,!0)));let U=Ue.values(f,g,x,m);Ue.unit==2?ne=U[0]*w:ne=A(U[0],v,w,F)-A(0,v,w,F),ze=l0(M,S,A,v,w,F,ze),Ee=ze-ne+W}else ze=l0(M,S,A,v,w,F,ze),Ee=ze*o+W,ne=ze-Ee;Ee<1&&(Ee=0),ve>=ne/2&&(ve=0),Ee<5&&(k=_0);let St=Ee>0,Pe=ze-Ee-(St?ve:0);ne=k(Wd(Pe,q,X)),Q=(V==0?ne/2:V==ae?0:ne)-V*ae*((V==0?W/2:0)+(St?ve/2:0));let Ge={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bt=je?null:new Path2D,vt=null;if(Me!=null)vt=f.data[Me.series[1]];else{let{y0:U,y1:K}=l;U!=null&&K!=null&&(S=K.values(f,g,x,m),vt=U.values(f,g,x,m))}let I=j*ne,y=$*ne;for(let U=ae==1?x:m;U>=x&&U<=m;U+=ae){let K=S[U];if(K==null)continue;if(vt!=null){let ge=vt[U]??0;if(K-ge==0)continue;Je=D(ge,P,C,T)}let ie=v.distr!=2||l!=null?M[U]:U,te=A(ie,v,w,F),Fe=D(xt(K,nt),P,C,T),ue=k(te-Q),Le=k(Fn(Fe,Je)),Ce=k(Si(Fe,Je)),oe=Le-Ce;if(K!=null){let ge=K<0?y:I,Be=K<0?I:y;je?(ve>0&&dt[U]!=null&&le($e.get(dt[U]),ue,Ce+Jn(ve/2),ne,Fn(0,oe-ve),ge,Be),Ut[U]!=null&&le(N.get(Ut[U]),ue,Ce+Jn(ve/2),ne,Fn(0,oe-ve),ge,Be)):le(Bt,ue,Ce+Jn(ve/2),ne,Fn(0,oe-ve),ge,Be),xe(f,g,U,ue-ve/2,Ce,ne+ve,oe)}}return ve>0?Ge.stroke=je?$e:Bt:je||(Ge._fill=p.width==0?p._fill:p._stroke??p._fill,Ge.width=0),Ge.fill=je?N:Bt,Ge})}function rT(i,e){let t=xt(e?.alignGaps,0);return(n,s,r,o)=>xr(n,s,(a,c,l,u,h,d,f,g,x,m,p)=>{[r,o]=Mh(l,r,o);let M=a.pxRound,S=j=>M(d(j,u,m,g)),v=j=>M(f(j,h,p,x)),P,A,D;u.ori==0?(P=Ah,D=Mo,A=W0):(P=Ch,D=So,A=X0);let F=u.dir*(u.ori==0?1:-1),T=S(c[F==1?r:o]),w=T,C=[],k=[];for(let j=F==1?r:o;j>=r&&j<=o;j+=F)if(l[j]!=null){let ae=c[j],le=S(ae);C.push(w=le),k.push(v(l[j]))}let V={stroke:i(C,k,P,D,A,M),fill:null,clip:null,band:null,gaps:null,flags:yo},W=V.stroke,[X,q]=lf(n,s);if(a.fill!=null||X!=0){let j=V.fill=new Path2D(W),$=a.fillTo(n,s,a.min,a.max,X),ae=v($);D(j,w,ae),D(j,T,ae)}if(!a.spanGaps){let j=[];j.push(...cf(c,l,r,o,F,S,t)),V.gaps=j=a.gaps(n,s,r,o,j),V.clip=Th(j,u.ori,g,x,m,p)}return q!=0&&(V.band=q==2?[ss(n,s,r,o,W,-1),ss(n,s,r,o,W,1)]:ss(n,s,r,o,W,q)),V})}function oT(i){return rT(aT,i)}function aT(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=i[d+1]-i[d],l[d]=u[d]/h[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/l[d-1]+(h[d]+2*h[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+h[d]/3,e[d]+c[d]*h[d]/3,i[d+1]-h[d]/3,e[d+1]-c[d+1]*h[d]/3,i[d+1],e[d+1])}return a}var $d=new Set;function c0(){for(let i of $d)i.syncRect(!0)}bo&&(gr(Vw,go,c0),gr(Hw,go,c0,!0),gr(vh,go,()=>{Mn.pxRatio=bt}));var lT=$0(),cT=q0();function h0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Zd(r,o,e,t))}function hT(i,e){return i.map((t,n)=>n==0?{}:en({},e,t))}function Zd(i,e,t,n){return en({},e==0?t:n,i)}function Z0(i,e,t){return e==null?xo:[e,t]}var uT=Z0;function dT(i,e,t){return e==null?xo:yh(e,t,ef,!0)}function K0(i,e,t,n){return e==null?xo:Sh(e,t,i.scales[n].log,!1)}var fT=K0;function J0(i,e,t,n){return e==null?xo:Qd(e,t,i.scales[n].log,!1)}var pT=J0;function mT(i,e,t,n,s){let r=Fn(Hg(i),Hg(e)),o=e-i,a=Mi(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?Ds.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function u0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=an((t=+s)*bt))+"px"),[i,e,t]}function gT(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Nt(e[2]*bt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Mn(i,e,t){let n={mode:xt(i.mode,1)},s=n.mode;function r(_,b,R,L){let z=b.valToPct(_);return L+R*(b.dir==-1?1-z:z)}function o(_,b,R,L){let z=b.valToPct(_);return L+R*(b.dir==-1?z:1-z)}function a(_,b,R,L){return b.ori==0?r(_,b,R,L):o(_,b,R,L)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=li(Sw);if(i.id!=null&&(l.id=i.id),Kn(l,i.class),i.title){let _=li(Tw,l);_.textContent=i.title}let u=bi("canvas"),h=n.ctx=u.getContext("2d"),d=li(Aw,l);gr("click",d,_=>{_.target===g&&(zt!=wr||qt!=Er)&&xn.click(n,_)},!0);let f=n.under=li(Cw,d);d.appendChild(u);let g=n.over=li(Rw,d);i=vo(i);let x=+xt(i.pxAlign,1),m=a0(x);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,M=n.series=s==1?h0(i.series||[],e0,r0,!1):hT(i.series||[null],s0),S=n.axes=h0(i.axes||[],Qg,n0,!0),v=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=ut(_.fill||null),_.dir=xt(_.dir,-1)});let A=s==2?M[1].facets[0].scale:M[0].scale,D={axes:S_,series:Os},F=(i.drawOrder||["axes","series"]).map(_=>D[_]);function T(_){let b=_.distr==3?R=>is(R>0?R:_.clamp(n,R,_.min,_.max,_.key)):_.distr==4?R=>Fd(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=b(R),{_min:z,_max:Y}=_,se=Y-z;return(L-z)/se}}function w(_){let b=v[_];if(b==null){let R=(i.scales||ka)[_]||ka;if(R.from!=null){w(R.from);let L=en({},v[R.from],R,{key:_});L.valToPct=T(L),v[_]=L}else{b=v[_]=en({},_==A?B0:jE,R),b.key=_;let L=b.time,z=b.range,Y=Ls(z);if((_!=A||s==2&&!L)&&(Y&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?Bg:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?Bg:{mode:1,hard:z[1],soft:z[1]}},Y=!1),!Y&&Eh(z))){let se=z;z=(ce,me,Ae)=>me==null?xo:yh(me,Ae,se)}b.range=ut(z||(L?uT:_==A?b.distr==3?fT:b.distr==4?pT:Z0:b.distr==3?K0:b.distr==4?J0:dT)),b.auto=ut(Y?!1:b.auto),b.clamp=ut(b.clamp||JE),b._min=b._max=null,b.valToPct=T(b)}}}w("x"),w("y"),s==1&&M.forEach(_=>{w(_.scale)}),S.forEach(_=>{w(_.scale)});for(let _ in i.scales)w(_);let C=v[A],k=C.distr,V,W;C.ori==0?(Kn(l,ww),V=r,W=o):(Kn(l,Ew),V=o,W=r);let X={};for(let _ in v){let b=v[_];(b.min!=null||b.max!=null)&&(X[_]={min:b.min,max:b.max},b.min=b.max=null)}let q=i.tzDate||(_=>new Date(an(_/p))),j=i.fmtDate||sf,$=p==1?wE(q):AE(q),ae=Kg(q,Zg(p==1?SE:TE,j)),le=jg(q,Jg(RE,j)),xe=[],Me=n.legend=en({},LE,i.legend),_e=n.cursor=en({},kE,{drag:{y:s==2}},i.cursor),nt=Me.show,Je=_e.show,Q=Me.markers;Me.idxs=xe,Q.width=ut(Q.width),Q.dash=ut(Q.dash),Q.stroke=ut(Q.stroke),Q.fill=ut(Q.fill);let ne,Ee,ze,ve=[],je=[],Ut,N=!1,dt={};if(Me.live){let _=M[1]?M[1].values:null;N=_!=null,Ut=N?_(n,1,0):{_:0};for(let b in Ut)dt[b]=Jd}if(nt)if(ne=bi("table",Uw,l),ze=bi("tbody",null,ne),Me.mount(n,ne),N){Ee=bi("thead",null,ne,ze);let _=bi("tr",null,Ee);bi("th",null,_);for(var $e in Ut)bi("th",Tg,_).textContent=$e}else Kn(ne,Ow),Me.live&&Kn(ne,Fw);let We={show:!0},Ue={show:!1};function St(_,b){if(b==0&&(N||!Me.live||s==2))return xo;let R=[],L=bi("tr",kw,ze,ze.childNodes[b]);Kn(L,_.class),_.show||Kn(L,mr);let z=bi("th",null,L);if(Q.show){let ce=li(Bw,z);if(b>0){let me=Q.width(n,b);me&&(ce.style.border=me+"px "+Q.dash(n,b)+" "+Q.stroke(n,b)),ce.style.background=Q.fill(n,b)}}let Y=li(Tg,z);_.label instanceof HTMLElement?Y.appendChild(_.label):Y.textContent=_.label,b>0&&(Q.show||(Y.style.color=_.width>0?Q.stroke(n,b):Q.fill(n,b)),Ge("click",z,ce=>{if(_e._lock)return;_n(ce);let me=M.indexOf(_);if((ce.ctrlKey||ce.metaKey)!=Me.isolate){let Ae=M.some((Re,Ne)=>Ne>0&&Ne!=me&&Re.show);M.forEach((Re,Ne)=>{Ne>0&&Ti(Ne,Ae?Ne==me?We:Ue:We,!0,jt.setSeries)})}else Ti(me,{show:!_.show},!0,jt.setSeries)},!1),On&&Ge(Pg,z,ce=>{_e._lock||(_n(ce),Ti(M.indexOf(_),Ar,!0,jt.setSeries))},!1));for(var se in Ut){let ce=bi("td",zw,L);ce.textContent="--",R.push(ce)}return[L,R]}let Pe=new Map;function Ge(_,b,R,L=!0){let z=Pe.get(b)||{},Y=_e.bind[_](n,b,R,L);Y&&(gr(_,b,z[_]=Y),Pe.set(b,z))}function Bt(_,b,R){let L=Pe.get(b)||{};for(let z in L)(_==null||z==_)&&(Gd(z,b,L[z]),delete L[z]);_==null&&Pe.delete(b)}let vt=0,I=0,y=0,U=0,K=0,ie=0,te=K,Fe=ie,ue=y,Le=U,Ce=0,oe=0,ge=0,Be=0;n.bbox={};let ke=!1,ye=!1,Ke=!1,B=!1,de=!1,pe=!1;function Ie(_,b,R){(R||_!=n.width||b!=n.height)&&he(_,b),yr(!1),Ke=!0,ye=!0,br()}function he(_,b){n.width=vt=y=_,n.height=I=U=b,K=ie=0,At(),pt();let R=n.bbox;Ce=R.left=fr(K*bt,.5),oe=R.top=fr(ie*bt,.5),ge=R.width=fr(y*bt,.5),Be=R.height=fr(U*bt,.5)}let re=3;function Oe(){let _=!1,b=0;for(;!_;){b++;let R=b_(b),L=M_(b);_=b==re||R&&L,_||(he(n.width,n.height),ye=!0)}}function Qe({width:_,height:b}){Ie(_,b)}n.setSize=Qe;function At(){let _=!1,b=!1,R=!1,L=!1;S.forEach((z,Y)=>{if(z.show&&z._show){let{side:se,_size:ce}=z,me=se%2,Ae=z.label!=null?z.labelSize:0,Re=ce+Ae;Re>0&&(me?(y-=Re,se==3?(K+=Re,L=!0):R=!0):(U-=Re,se==0?(ie+=Re,_=!0):b=!0))}}),Vi[0]=_,Vi[1]=R,Vi[2]=b,Vi[3]=L,y-=Ei[1]+Ei[3],K+=Ei[3],U-=Ei[2]+Ei[0],ie+=Ei[0]}function pt(){let _=K+y,b=ie+U,R=K,L=ie;function z(Y,se){switch(Y){case 1:return _+=se,_-se;case 2:return b+=se,b-se;case 3:return R-=se,R+se;case 0:return L-=se,L+se}}S.forEach((Y,se)=>{if(Y.show&&Y._show){let ce=Y.side;Y._pos=z(ce,Y._size),Y.label!=null&&(Y._lpos=z(ce,Y.labelSize))}})}if(_e.dataIdx==null){let _=_e.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let R=_.prox=ut(_.prox),L=_.bias??=0;_e.dataIdx=(z,Y,se,ce)=>{if(Y==0)return se;let me=se,Ae=R(z,Y,se,ce)??Dt,Re=Ae>=0&&Ae<Dt,Ne=C.ori==0?y:U,et=_e.left,yt=e[0],gt=e[Y];if(b.has(gt[se])){me=null;let ct=null,Ze=null,He;if(L==0||L==-1)for(He=se;ct==null&&He-- >0;)b.has(gt[He])||(ct=He);if(L==0||L==1)for(He=se;Ze==null&&He++<gt.length;)b.has(gt[He])||(Ze=He);if(ct!=null||Ze!=null)if(Re){let Ht=ct==null?-1/0:V(yt[ct],C,Ne,0),Zt=Ze==null?1/0:V(yt[Ze],C,Ne,0),pn=et-Ht,Ct=Zt-et;pn<=Ct?pn<=Ae&&(me=ct):Ct<=Ae&&(me=Ze)}else me=Ze==null?ct:ct==null?Ze:se-ct<=Ze-se?ct:Ze}else Re&&ln(et-V(yt[se],C,Ne,0))>Ae&&(me=null);return me}}let _n=_=>{_e.event=_};_e.idxs=xe,_e._lock=!1;let Lt=_e.points;Lt.show=ut(Lt.show),Lt.size=ut(Lt.size),Lt.stroke=ut(Lt.stroke),Lt.width=ut(Lt.width),Lt.fill=ut(Lt.fill);let zn=n.focus=en({},i.focus||{alpha:.3},_e.focus),On=zn.prox>=0,wi=On&&Lt.one,An=[],zi=[],ui=[];function wo(_,b){let R=Lt.show(n,b);if(R instanceof HTMLElement)return Kn(R,Nw),Kn(R,_.class),Bi(R,-10,-10,y,U),g.insertBefore(R,An[b]),R}function Us(_,b){if(s==1||b>0){let R=s==1&&v[_.scale].time,L=_.value;_.value=R?Xg(L)?jg(q,Jg(L,j)):L||le:L||$E,_.label=_.label||(R?zE:BE)}if(wi||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||lT||jw,_.fillTo=ut(_.fillTo||QE),_.pxAlign=+xt(_.pxAlign,x),_.pxRound=a0(_.pxAlign),_.stroke=ut(_.stroke||null),_.fill=ut(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=ZE(Fn(1,_.width),1),L=_.points=en({},{size:R,width:Fn(1,R*.2),stroke:_.stroke,space:R*2,paths:cT,_stroke:null,_fill:null},_.points);L.show=ut(L.show),L.filter=ut(L.filter),L.fill=ut(L.fill),L.stroke=ut(L.stroke),L.paths=ut(L.paths),L.pxAlign=_.pxAlign}if(nt){let R=St(_,b);ve.splice(b,0,R[0]),je.splice(b,0,R[1]),Me.values.push(null)}if(Je){xe.splice(b,0,null);let R=null;wi?b==0&&(R=wo(_,b)):b>0&&(R=wo(_,b)),An.splice(b,0,R),zi.splice(b,0,0),ui.splice(b,0,0)}fn("addSeries",b)}function Ha(_,b){b=b??M.length,_=s==1?Zd(_,b,e0,r0):Zd(_,b,{},s0),M.splice(b,0,_),Us(M[b],b)}n.addSeries=Ha;function Ga(_){if(M.splice(_,1),nt){Me.values.splice(_,1),je.splice(_,1);let b=ve.splice(_,1)[0];Bt(null,b.firstChild),b.remove()}Je&&(xe.splice(_,1),An.splice(_,1)[0].remove(),zi.splice(_,1),ui.splice(_,1)),fn("delSeries",_)}n.delSeries=Ga;let Vi=[!1,!1,!1,!1];function Uh(_,b){if(_._show=_.show,_.show){let R=_.side%2,L=v[_.scale];L==null&&(_.scale=R?M[1].scale:A,L=v[_.scale]);let z=L.time;_.size=ut(_.size),_.space=ut(_.space),_.rotate=ut(_.rotate),Ls(_.incrs)&&_.incrs.forEach(se=>{!Ds.has(se)&&Ds.set(se,y0(se))}),_.incrs=ut(_.incrs||(L.distr==2?yE:z?p==1?ME:EE:pr)),_.splits=ut(_.splits||(z&&L.distr==1?$:L.distr==3?Xd:L.distr==4?GE:HE)),_.stroke=ut(_.stroke),_.grid.stroke=ut(_.grid.stroke),_.ticks.stroke=ut(_.ticks.stroke),_.border.stroke=ut(_.border.stroke);let Y=_.values;_.values=Ls(Y)&&!Ls(Y[0])?ut(Y):z?Ls(Y)?Kg(q,Zg(Y,j)):Xg(Y)?CE(q,Y):Y||ae:Y||VE,_.filter=ut(_.filter||(L.distr>=3&&L.log==10?qE:L.distr==3&&L.log==2?YE:x0)),_.font=u0(_.font),_.labelFont=u0(_.labelFont),_._size=_.size(n,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Vi[b]=!0,_._el=li(Pw,d))}}function Fs(_,b,R,L){let[z,Y,se,ce]=R,me=b%2,Ae=0;return me==0&&(ce||Y)&&(Ae=b==0&&!z||b==2&&!se?an(Qg.size/3):0),me==1&&(z||se)&&(Ae=b==1&&!Y||b==3&&!ce?an(n0.size/2):0),Ae}let Wa=n.padding=(i.padding||[Fs,Fs,Fs,Fs]).map(_=>ut(xt(_,Fs))),Ei=n._padding=Wa.map((_,b)=>_(n,b,Vi,0)),tn,E=null,H=null,J=s==1?M[0].idxs:null,Z=null,G=!1;function fe(_,b){if(e=_??[],n.data=n._data=e,s==2){tn=0;for(let R=1;R<M.length;R++)tn+=e[R][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Z=e[0],tn=Z.length;let R=e;if(k==2){R=e.slice();let L=R[0]=Array(tn);for(let z=0;z<tn;z++)L[z]=z}n._data=e=R}if(yr(!0),fn("setData"),k==2&&(Ke=!0),b!==!1){let R=C;R.auto(n,G)?Se():ls(A,R.min,R.max),B=B||_e.left>=0,pe=!0,br()}}n.setData=fe;function Se(){G=!0;let _,b;s==1&&(tn>0?(E=J[0]=0,H=J[1]=tn-1,_=e[0][E],b=e[0][H],k==2?(_=E,b=H):_==b&&(k==3?[_,b]=Sh(_,_,C.log,!1):k==4?[_,b]=Qd(_,_,C.log,!1):C.time?b=_+an(86400/p):[_,b]=yh(_,b,ef,!0))):(E=J[0]=_=null,H=J[1]=b=null)),ls(A,_,b)}let De,Te,qe,Ye,Ve,rt,mt,Ft,wt,it;function Xe(_,b,R,L,z,Y){_??=Cg,R??=nf,L??="butt",z??=Cg,Y??="round",_!=De&&(h.strokeStyle=De=_),z!=Te&&(h.fillStyle=Te=z),b!=qe&&(h.lineWidth=qe=b),Y!=Ve&&(h.lineJoin=Ve=Y),L!=rt&&(h.lineCap=rt=L),R!=Ye&&h.setLineDash(Ye=R)}function Ot(_,b,R,L){b!=Te&&(h.fillStyle=Te=b),_!=mt&&(h.font=mt=_),R!=Ft&&(h.textAlign=Ft=R),L!=wt&&(h.textBaseline=wt=L)}function ht(_,b,R,L,z=0){if(L.length>0&&_.auto(n,G)&&(b==null||b.min==null)){let Y=xt(E,0),se=xt(H,L.length-1),ce=R.min==null?qw(L,Y,se,z,_.distr==3):[R.min,R.max];_.min=Si(_.min,R.min=ce[0]),_.max=Fn(_.max,R.max=ce[1])}}let Sn={min:null,max:null};function rs(){for(let L in v){let z=v[L];X[L]==null&&(z.min==null||X[A]!=null&&z.auto(n,G))&&(X[L]=Sn)}for(let L in v){let z=v[L];X[L]==null&&z.from!=null&&X[z.from]!=null&&(X[L]=Sn)}X[A]!=null&&yr(!0);let _={};for(let L in X){let z=X[L];if(z!=null){let Y=_[L]=vo(v[L],tE);if(z.min!=null)en(Y,z);else if(L!=A||s==2)if(tn==0&&Y.from==null){let se=Y.range(n,null,null,L);Y.min=se[0],Y.max=se[1]}else Y.min=Dt,Y.max=-Dt}}if(tn>0){M.forEach((L,z)=>{if(s==1){let Y=L.scale,se=X[Y];if(se==null)return;let ce=_[Y];if(z==0){let me=ce.range(n,ce.min,ce.max,Y);ce.min=me[0],ce.max=me[1],E=Mi(ce.min,e[0]),H=Mi(ce.max,e[0]),H-E>1&&(e[0][E]<ce.min&&E++,e[0][H]>ce.max&&H--),L.min=Z[E],L.max=Z[H]}else L.show&&L.auto&&ht(ce,se,L,e[z],L.sorted);L.idxs[0]=E,L.idxs[1]=H}else if(z>0&&L.show&&L.auto){let[Y,se]=L.facets,ce=Y.scale,me=se.scale,[Ae,Re]=e[z],Ne=_[ce],et=_[me];Ne!=null&&ht(Ne,X[ce],Y,Ae,Y.sorted),et!=null&&ht(et,X[me],se,Re,se.sorted),L.min=se.min,L.max=se.max}});for(let L in _){let z=_[L],Y=X[L];if(z.from==null&&(Y==null||Y.min==null)){let se=z.range(n,z.min==Dt?null:z.min,z.max==-Dt?null:z.max,L);z.min=se[0],z.max=se[1]}}}for(let L in _){let z=_[L];if(z.from!=null){let Y=_[z.from];if(Y.min==null)z.min=z.max=null;else{let se=z.range(n,Y.min,Y.max,L);z.min=se[0],z.max=se[1]}}}let b={},R=!1;for(let L in _){let z=_[L],Y=v[L];if(Y.min!=z.min||Y.max!=z.max){Y.min=z.min,Y.max=z.max;let se=Y.distr;Y._min=se==3?is(Y.min):se==4?Fd(Y.min,Y.asinh):se==100?Y.fwd(Y.min):Y.min,Y._max=se==3?is(Y.max):se==4?Fd(Y.max,Y.asinh):se==100?Y.fwd(Y.max):Y.max,b[L]=R=!0}}if(R){M.forEach((L,z)=>{s==2?z>0&&b.y&&(L._paths=null):b[L.scale]&&(L._paths=null)});for(let L in b)Ke=!0,fn("setScale",L);Je&&_e.left>=0&&(B=pe=!0)}for(let L in X)X[L]=null}function Cn(_){let b=Wd(E-1,0,tn-1),R=Wd(H+1,0,tn-1);for(;_[b]==null&&b>0;)b--;for(;_[R]==null&&R<tn-1;)R++;return[b,R]}function Os(){if(tn>0){let _=M.some(b=>b._focus)&&it!=zn.alpha;_&&(h.globalAlpha=it=zn.alpha),M.forEach((b,R)=>{if(R>0&&b.show&&(kt(R,!1),kt(R,!0),b._paths==null)){let L=it;it!=b.alpha&&(h.globalAlpha=it=b.alpha);let z=s==2?[0,e[R][0].length-1]:Cn(e[R]);b._paths=b.paths(n,R,z[0],z[1]),it!=L&&(h.globalAlpha=it=L)}}),M.forEach((b,R)=>{if(R>0&&b.show){let L=it;it!=b.alpha&&(h.globalAlpha=it=b.alpha),b._paths!=null&&Rn(R,!1);{let z=b._paths!=null?b._paths.gaps:null,Y=b.points.show(n,R,E,H,z),se=b.points.filter(n,R,Y,z);(Y||se)&&(b.points._paths=b.points.paths(n,R,E,H,se),Rn(R,!0))}it!=L&&(h.globalAlpha=it=L),fn("drawSeries",R)}}),_&&(h.globalAlpha=it=1)}}function kt(_,b){let R=b?M[_].points:M[_];R._stroke=R.stroke(n,_),R._fill=R.fill(n,_)}function Rn(_,b){let R=b?M[_].points:M[_],{stroke:L,fill:z,clip:Y,flags:se,_stroke:ce=R._stroke,_fill:me=R._fill,_width:Ae=R.width}=R._paths;Ae=Nt(Ae*bt,3);let Re=null,Ne=Ae%2/2;b&&me==null&&(me=Ae>0?"#fff":ce);let et=R.pxAlign==1&&Ne>0;if(et&&h.translate(Ne,Ne),!b){let yt=Ce-Ae/2,gt=oe-Ae/2,ct=ge+Ae,Ze=Be+Ae;Re=new Path2D,Re.rect(yt,gt,ct,Ze)}b?hn(ce,Ae,R.dash,R.cap,me,L,z,se,Y):kn(_,ce,Ae,R.dash,R.cap,me,L,z,se,Re,Y),et&&h.translate(-Ne,-Ne)}function kn(_,b,R,L,z,Y,se,ce,me,Ae,Re){let Ne=!1;me!=0&&P.forEach((et,yt)=>{if(et.series[0]==_){let gt=M[et.series[1]],ct=e[et.series[1]],Ze=(gt._paths||ka).band;Ls(Ze)&&(Ze=et.dir==1?Ze[0]:Ze[1]);let He,Ht=null;gt.show&&Ze&&$w(ct,E,H)?(Ht=et.fill(n,yt)||Y,He=gt._paths.clip):Ze=null,hn(b,R,L,z,Ht,se,ce,me,Ae,Re,He,Ze),Ne=!0}}),Ne||hn(b,R,L,z,Y,se,ce,me,Ae,Re)}let cn=yo|Yd;function hn(_,b,R,L,z,Y,se,ce,me,Ae,Re,Ne){Xe(_,b,R,L,z),(me||Ae||Ne)&&(h.save(),me&&h.clip(me),Ae&&h.clip(Ae)),Ne?(ce&cn)==cn?(h.clip(Ne),Re&&h.clip(Re),ei(z,se),os(_,Y,b)):ce&Yd?(ei(z,se),h.clip(Ne),os(_,Y,b)):ce&yo&&(h.save(),h.clip(Ne),Re&&h.clip(Re),ei(z,se),h.restore(),os(_,Y,b)):(ei(z,se),os(_,Y,b)),(me||Ae||Ne)&&h.restore()}function os(_,b,R){R>0&&(b instanceof Map?b.forEach((L,z)=>{h.strokeStyle=De=z,h.stroke(L)}):b!=null&&_&&h.stroke(b))}function ei(_,b){b instanceof Map?b.forEach((R,L)=>{h.fillStyle=Te=L,h.fill(R)}):b!=null&&_&&h.fill(b)}function y_(_,b,R,L){let z=S[_],Y;if(L<=0)Y=[0,0];else{let se=z._space=z.space(n,_,b,R,L),ce=z._incrs=z.incrs(n,_,b,R,L,se);Y=mT(b,R,ce,L,se)}return z._found=Y}function Fh(_,b,R,L,z,Y,se,ce,me,Ae){let Re=se%2/2;x==1&&h.translate(Re,Re),Xe(ce,se,me,Ae,ce),h.beginPath();let Ne,et,yt,gt,ct=z+(L==0||L==3?-Y:Y);R==0?(et=z,gt=ct):(Ne=z,yt=ct);for(let Ze=0;Ze<_.length;Ze++)b[Ze]!=null&&(R==0?Ne=yt=_[Ze]:et=gt=_[Ze],h.moveTo(Ne,et),h.lineTo(yt,gt));h.stroke(),x==1&&h.translate(-Re,-Re)}function b_(_){let b=!0;return S.forEach((R,L)=>{if(!R.show)return;let z=v[R.scale];if(z.min==null){R._show&&(b=!1,R._show=!1,yr(!1));return}else R._show||(b=!1,R._show=!0,yr(!1));let Y=R.side,se=Y%2,{min:ce,max:me}=z,[Ae,Re]=y_(L,ce,me,se==0?y:U);if(Re==0)return;let Ne=z.distr==2,et=R._splits=R.splits(n,L,ce,me,Ae,Re,Ne),yt=z.distr==2?et.map(He=>Z[He]):et,gt=z.distr==2?Z[et[1]]-Z[et[0]]:Ae,ct=R._values=R.values(n,R.filter(n,yt,L,Re,gt),L,Re,gt);R._rotate=Y==2?R.rotate(n,ct,L,Re):0;let Ze=R._size;R._size=ci(R.size(n,ct,L,_)),Ze!=null&&R._size!=Ze&&(b=!1)}),b}function M_(_){let b=!0;return Wa.forEach((R,L)=>{let z=R(n,L,Vi,_);z!=Ei[L]&&(b=!1),Ei[L]=z}),b}function S_(){for(let _=0;_<S.length;_++){let b=S[_];if(!b.show||!b._show)continue;let R=b.side,L=R%2,z,Y,se=b.stroke(n,_),ce=R==0||R==3?-1:1,[me,Ae]=b._found;if(b.label!=null){let In=b.labelGap*ce,Gn=an((b._lpos+In)*bt);Ot(b.labelFont[0],se,"center",R==2?"top":Ag),h.save(),L==1?(z=Y=0,h.translate(Gn,an(oe+Be/2)),h.rotate((R==3?-xh:xh)/2)):(z=an(Ce+ge/2),Y=Gn);let zs=g0(b.label)?b.label(n,_,me,Ae):b.label;h.fillText(zs,z,Y),h.restore()}if(Ae==0)continue;let Re=v[b.scale],Ne=L==0?ge:Be,et=L==0?Ce:oe,yt=b._splits,gt=Re.distr==2?yt.map(In=>Z[In]):yt,ct=Re.distr==2?Z[yt[1]]-Z[yt[0]]:me,Ze=b.ticks,He=b.border,Ht=Ze.show?Ze.size:0,Zt=an(Ht*bt),pn=an((b.alignTo==2?b._size-Ht-b.gap:b.gap)*bt),Ct=b._rotate*-xh/180,Kt=m(b._pos*bt),Vn=(Zt+pn)*ce,Pn=Kt+Vn;Y=L==0?Pn:0,z=L==1?Pn:0;let ti=b.font[0],di=b.align==1?po:b.align==2?Dd:Ct>0?po:Ct<0?Dd:L==0?"center":R==3?Dd:po,Ci=Ct||L==1?"middle":R==2?"top":Ag;Ot(ti,se,di,Ci);let Hn=b.font[1]*b.lineGap,ni=yt.map(In=>m(a(In,Re,Ne,et))),fi=b._values;for(let In=0;In<fi.length;In++){let Gn=fi[In];if(Gn!=null){L==0?z=ni[In]:Y=ni[In],Gn=""+Gn;let zs=Gn.indexOf(`
`)==-1?[Gn]:Gn.split(/\n/gm);for(let Ln=0;Ln<zs.length;Ln++){let Uf=zs[Ln];Ct?(h.save(),h.translate(z,Y+Ln*Hn),h.rotate(Ct),h.fillText(Uf,0,0),h.restore()):h.fillText(Uf,z,Y+Ln*Hn)}}}Ze.show&&Fh(ni,Ze.filter(n,gt,_,Ae,ct),L,R,Kt,Zt,Nt(Ze.width*bt,3),Ze.stroke(n,_),Ze.dash,Ze.cap);let Ri=b.grid;Ri.show&&Fh(ni,Ri.filter(n,gt,_,Ae,ct),L,L==0?2:1,L==0?oe:Ce,L==0?Be:ge,Nt(Ri.width*bt,3),Ri.stroke(n,_),Ri.dash,Ri.cap),He.show&&Fh([Kt],[1],L==0?1:0,L==0?1:2,L==1?oe:Ce,L==1?Be:ge,Nt(He.width*bt,3),He.stroke(n,_),He.dash,He.cap)}fn("drawAxes")}function yr(_){M.forEach((b,R)=>{R>0&&(b._paths=null,_&&(s==1?(b.min=null,b.max=null):b.facets.forEach(L=>{L.min=null,L.max=null})))})}let Xa=!1,Oh=!1,Eo=[];function w_(){Oh=!1;for(let _=0;_<Eo.length;_++)fn(...Eo[_]);Eo.length=0}function br(){Xa||(lE(_f),Xa=!0)}function E_(_,b=!1){Xa=!0,Oh=b,_(n),_f(),b&&Eo.length>0&&queueMicrotask(w_)}n.batch=E_;function _f(){if(ke&&(rs(),ke=!1),Ke&&(Oe(),Ke=!1),ye){if(Xt(f,po,K),Xt(f,"top",ie),Xt(f,Na,y),Xt(f,Ua,U),Xt(g,po,K),Xt(g,"top",ie),Xt(g,Na,y),Xt(g,Ua,U),Xt(d,Na,vt),Xt(d,Ua,I),u.width=an(vt*bt),u.height=an(I*bt),S.forEach(({_el:_,_show:b,_size:R,_pos:L,side:z})=>{if(_!=null)if(b){let Y=z===3||z===0?R:0,se=z%2==1;Xt(_,se?"left":"top",L-Y),Xt(_,se?"width":"height",R),Xt(_,se?"top":"left",se?ie:K),Xt(_,se?"height":"width",se?U:y),Hd(_,mr)}else Kn(_,mr)}),De=Te=qe=Ve=rt=mt=Ft=wt=Ye=null,it=1,Co(!0),K!=te||ie!=Fe||y!=ue||U!=Le){yr(!1);let _=y/ue,b=U/Le;if(Je&&!B&&_e.left>=0){_e.left*=_,_e.top*=b,Mr&&Bi(Mr,an(_e.left),0,y,U),Sr&&Bi(Sr,0,an(_e.top),y,U);for(let R=0;R<An.length;R++){let L=An[R];L!=null&&(zi[R]*=_,ui[R]*=b,Bi(L,ci(zi[R]),ci(ui[R]),y,U))}}if(Vt.show&&!de&&Vt.left>=0&&Vt.width>0){Vt.left*=_,Vt.width*=_,Vt.top*=b,Vt.height*=b;for(let R in Gh)Xt(Tr,R,Vt[R])}te=K,Fe=ie,ue=y,Le=U}fn("setSize"),ye=!1}vt>0&&I>0&&(h.clearRect(0,0,u.width,u.height),fn("drawClear"),F.forEach(_=>_()),fn("draw")),Vt.show&&de&&(qa(Vt),de=!1),Je&&B&&(Bs(null,!0,!1),B=!1),Me.show&&Me.live&&pe&&(Vh(),pe=!1),c||(c=!0,n.status=1,fn("ready")),G=!1,Xa=!1}n.redraw=(_,b)=>{Ke=b||!1,_!==!1?ls(A,C.min,C.max):br()};function kh(_,b){let R=v[_];if(R.from==null){if(tn==0){let L=R.range(n,b.min,b.max,_);b.min=L[0],b.max=L[1]}if(b.min>b.max){let L=b.min;b.min=b.max,b.max=L}if(tn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==A&&R.distr==2&&tn>0&&(b.min=Mi(b.min,e[0]),b.max=Mi(b.max,e[0]),b.min==b.max&&b.max++),X[_]=b,ke=!0,br()}}n.setScale=kh;let Bh,zh,Mr,Sr,xf,vf,wr,Er,yf,bf,zt,qt,as=!1,xn=_e.drag,un=xn.x,dn=xn.y;Je&&(_e.x&&(Bh=li(Lw,g)),_e.y&&(zh=li(Dw,g)),C.ori==0?(Mr=Bh,Sr=zh):(Mr=zh,Sr=Bh),zt=_e.left,qt=_e.top);let Vt=n.select=en({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Tr=Vt.show?li(Iw,Vt.over?g:f):null;function qa(_,b){if(Vt.show){for(let R in _)Vt[R]=_[R],R in Gh&&Xt(Tr,R,_[R]);b!==!1&&fn("setSelect")}}n.setSelect=qa;function T_(_){if(M[_].show)nt&&Hd(ve[_],mr);else if(nt&&Kn(ve[_],mr),Je){let R=wi?An[0]:An[_];R!=null&&Bi(R,-10,-10,y,U)}}function ls(_,b,R){kh(_,{min:b,max:R})}function Ti(_,b,R,L){b.focus!=null&&I_(_),b.show!=null&&M.forEach((z,Y)=>{Y>0&&(_==Y||_==null)&&(z.show=b.show,T_(Y),s==2?(ls(z.facets[0].scale,null,null),ls(z.facets[1].scale,null,null)):ls(z.scale,null,null),br())}),R!==!1&&fn("setSeries",_,b),L&&Ro("setSeries",n,_,b)}n.setSeries=Ti;function A_(_,b){en(P[_],b)}function C_(_,b){_.fill=ut(_.fill||null),_.dir=xt(_.dir,-1),b=b??P.length,P.splice(b,0,_)}function R_(_){_==null?P.length=0:P.splice(_,1)}n.addBand=C_,n.setBand=A_,n.delBand=R_;function P_(_,b){M[_].alpha=b,Je&&An[_]!=null&&(An[_].style.opacity=b),nt&&ve[_]&&(ve[_].style.opacity=b)}let Hi,cs,ks,Ar={focus:!0};function I_(_){if(_!=ks){let b=_==null,R=zn.alpha!=1;M.forEach((L,z)=>{if(s==1||z>0){let Y=b||z==0||z==_;L._focus=b?null:Y,R&&P_(z,Y?1:zn.alpha)}}),ks=_,R&&br()}}nt&&On&&Ge(Ig,ne,_=>{_e._lock||(_n(_),ks!=null&&Ti(null,Ar,!0,jt.setSeries))});function Ai(_,b,R){let L=v[b];R&&(_=_/bt-(L.ori==1?ie:K));let z=y;L.ori==1&&(z=U,_=z-_),L.dir==-1&&(_=z-_);let Y=L._min,se=L._max,ce=_/z,me=Y+(se-Y)*ce,Ae=L.distr;return Ae==3?_o(10,me):Ae==4?Kw(me,L.asinh):Ae==100?L.bwd(me):me}function L_(_,b){let R=Ai(_,A,b);return Mi(R,e[0],E,H)}n.valToIdx=_=>Mi(_,e[0]),n.posToIdx=L_,n.posToVal=Ai,n.valToPos=(_,b,R)=>v[b].ori==0?r(_,v[b],R?ge:y,R?Ce:0):o(_,v[b],R?Be:U,R?oe:0),n.setCursor=(_,b,R)=>{zt=_.left,qt=_.top,Bs(null,b,R)};function Mf(_,b){Xt(Tr,po,Vt.left=_),Xt(Tr,Na,Vt.width=b)}function Sf(_,b){Xt(Tr,"top",Vt.top=_),Xt(Tr,Ua,Vt.height=b)}let To=C.ori==0?Mf:Sf,Ao=C.ori==1?Mf:Sf;function D_(){if(nt&&Me.live)for(let _=s==2?1:0;_<M.length;_++){if(_==0&&N)continue;let b=Me.values[_],R=0;for(let L in b)je[_][R++].firstChild.nodeValue=b[L]}}function Vh(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{xe[L]=R}):eE(_.idx)||xe.fill(_.idx),Me.idx=xe[0]),nt&&Me.live){for(let R=0;R<M.length;R++)(R>0||s==1&&!N)&&N_(R,xe[R]);D_()}pe=!1,b!==!1&&fn("setLegend")}n.setLegend=Vh;function N_(_,b){let R=M[_],L=_==0&&k==2?Z:e[_],z;N?z=R.values(n,_,b)??dt:(z=R.value(n,b==null?null:L[b],_,b),z=z==null?dt:{_:z}),Me.values[_]=z}function Bs(_,b,R){yf=zt,bf=qt,[zt,qt]=_e.move(n,zt,qt),_e.left=zt,_e.top=qt,Je&&(Mr&&Bi(Mr,an(zt),0,y,U),Sr&&Bi(Sr,0,an(qt),y,U));let L,z=E>H;Hi=Dt,cs=null;let Y=C.ori==0?y:U,se=C.ori==1?y:U;if(zt<0||tn==0||z){L=_e.idx=null;for(let ce=0;ce<M.length;ce++){let me=An[ce];me!=null&&Bi(me,-10,-10,y,U)}On&&Ti(null,Ar,!0,_==null&&jt.setSeries),Me.live&&(xe.fill(L),pe=!0)}else{let ce,me,Ae;s==1&&(ce=C.ori==0?zt:qt,me=Ai(ce,A),L=_e.idx=Mi(me,e[0],E,H),Ae=V(e[0][L],C,Y,0));let Re=-10,Ne=-10,et=0,yt=0,gt=!0,ct="",Ze="";for(let He=s==2?1:0;He<M.length;He++){let Ht=M[He],Zt=xe[He],pn=Zt==null?null:s==1?e[He][Zt]:e[He][1][Zt],Ct=_e.dataIdx(n,He,L,me),Kt=Ct==null?null:s==1?e[He][Ct]:e[He][1][Ct];if(pe=pe||Kt!=pn||Ct!=Zt,xe[He]=Ct,He>0&&Ht.show){let Vn=Ct==null?-10:Ct==L?Ae:V(s==1?e[0][Ct]:e[He][0][Ct],C,Y,0),Pn=Kt==null?-10:W(Kt,s==1?v[Ht.scale]:v[Ht.facets[1].scale],se,0);if(On&&Kt!=null){let ti=C.ori==1?zt:qt,di=ln(zn.dist(n,He,Ct,Pn,ti));if(di<Hi){let Ci=zn.bias;if(Ci!=0){let Hn=Ai(ti,Ht.scale),ni=Kt>=0?1:-1,fi=Hn>=0?1:-1;fi==ni&&(fi==1?Ci==1?Kt>=Hn:Kt<=Hn:Ci==1?Kt<=Hn:Kt>=Hn)&&(Hi=di,cs=He)}else Hi=di,cs=He}}if(pe||wi){let ti,di;C.ori==0?(ti=Vn,di=Pn):(ti=Pn,di=Vn);let Ci,Hn,ni,fi,Ri,In,Gn=!0,zs=Lt.bbox;if(zs!=null){Gn=!1;let Ln=zs(n,He);ni=Ln.left,fi=Ln.top,Ci=Ln.width,Hn=Ln.height}else ni=ti,fi=di,Ci=Hn=Lt.size(n,He);if(In=Lt.fill(n,He),Ri=Lt.stroke(n,He),wi)He==cs&&Hi<=zn.prox&&(Re=ni,Ne=fi,et=Ci,yt=Hn,gt=Gn,ct=In,Ze=Ri);else{let Ln=An[He];Ln!=null&&(zi[He]=ni,ui[He]=fi,kg(Ln,Ci,Hn,Gn),Fg(Ln,In,Ri),Bi(Ln,ci(ni),ci(fi),y,U))}}}}if(wi){let He=zn.prox,Ht=ks==null?Hi<=He:Hi>He||cs!=ks;if(pe||Ht){let Zt=An[0];Zt!=null&&(zi[0]=Re,ui[0]=Ne,kg(Zt,et,yt,gt),Fg(Zt,ct,Ze),Bi(Zt,ci(Re),ci(Ne),y,U))}}}if(Vt.show&&as)if(_!=null){let[ce,me]=jt.scales,[Ae,Re]=jt.match,[Ne,et]=_.cursor.sync.scales,yt=_.cursor.drag;if(un=yt._x,dn=yt._y,un||dn){let{left:gt,top:ct,width:Ze,height:He}=_.select,Ht=_.scales[Ne].ori,Zt=_.posToVal,pn,Ct,Kt,Vn,Pn,ti=ce!=null&&Ae(ce,Ne),di=me!=null&&Re(me,et);ti&&un?(Ht==0?(pn=gt,Ct=Ze):(pn=ct,Ct=He),Kt=v[ce],Vn=V(Zt(pn,Ne),Kt,Y,0),Pn=V(Zt(pn+Ct,Ne),Kt,Y,0),To(Si(Vn,Pn),ln(Pn-Vn))):To(0,Y),di&&dn?(Ht==1?(pn=gt,Ct=Ze):(pn=ct,Ct=He),Kt=v[me],Vn=W(Zt(pn,et),Kt,se,0),Pn=W(Zt(pn+Ct,et),Kt,se,0),Ao(Si(Vn,Pn),ln(Pn-Vn))):Ao(0,se)}else Wh()}else{let ce=ln(yf-xf),me=ln(bf-vf);if(C.ori==1){let et=ce;ce=me,me=et}un=xn.x&&ce>=xn.dist,dn=xn.y&&me>=xn.dist;let Ae=xn.uni;Ae!=null?un&&dn&&(un=ce>=Ae,dn=me>=Ae,!un&&!dn&&(me>ce?dn=!0:un=!0)):xn.x&&xn.y&&(un||dn)&&(un=dn=!0);let Re,Ne;un&&(C.ori==0?(Re=wr,Ne=zt):(Re=Er,Ne=qt),To(Si(Re,Ne),ln(Ne-Re)),dn||Ao(0,se)),dn&&(C.ori==1?(Re=wr,Ne=zt):(Re=Er,Ne=qt),Ao(Si(Re,Ne),ln(Ne-Re)),un||To(0,Y)),!un&&!dn&&(To(0,0),Ao(0,0))}if(xn._x=un,xn._y=dn,_==null){if(R){if(Nf!=null){let[ce,me]=jt.scales;jt.values[0]=ce!=null?Ai(C.ori==0?zt:qt,ce):null,jt.values[1]=me!=null?Ai(C.ori==1?zt:qt,me):null}Ro(Nd,n,zt,qt,y,U,L)}if(On){let ce=R&&jt.setSeries,me=zn.prox;ks==null?Hi<=me&&Ti(cs,Ar,!0,ce):Hi>me?Ti(null,Ar,!0,ce):cs!=ks&&Ti(cs,Ar,!0,ce)}}pe&&(Me.idx=L,Vh()),b!==!1&&fn("setCursor")}let hs=null;Object.defineProperty(n,"rect",{get(){return hs==null&&Co(!1),hs}});function Co(_=!1){_?hs=null:(hs=g.getBoundingClientRect(),fn("syncRect",hs))}function wf(_,b,R,L,z,Y,se){_e._lock||as&&_!=null&&_.movementX==0&&_.movementY==0||(Hh(_,b,R,L,z,Y,se,!1,_!=null),_!=null?Bs(null,!0,!0):Bs(b,!0,!1))}function Hh(_,b,R,L,z,Y,se,ce,me){if(hs==null&&Co(!1),_n(_),_!=null)R=_.clientX-hs.left,L=_.clientY-hs.top;else{if(R<0||L<0){zt=-10,qt=-10;return}let[Ae,Re]=jt.scales,Ne=b.cursor.sync,[et,yt]=Ne.values,[gt,ct]=Ne.scales,[Ze,He]=jt.match,Ht=b.axes[0].side%2==1,Zt=C.ori==0?y:U,pn=C.ori==1?y:U,Ct=Ht?Y:z,Kt=Ht?z:Y,Vn=Ht?L:R,Pn=Ht?R:L;if(gt!=null?R=Ze(Ae,gt)?a(et,v[Ae],Zt,0):-10:R=Zt*(Vn/Ct),ct!=null?L=He(Re,ct)?a(yt,v[Re],pn,0):-10:L=pn*(Pn/Kt),C.ori==1){let ti=R;R=L,L=ti}}me&&(b==null||b.cursor.event.type==Nd)&&((R<=1||R>=y-1)&&(R=fr(R,y)),(L<=1||L>=U-1)&&(L=fr(L,U))),ce?(xf=R,vf=L,[wr,Er]=_e.move(n,R,L)):(zt=R,qt=L)}let Gh={width:0,height:0,left:0,top:0};function Wh(){qa(Gh,!1)}let Ef,Tf,Af,Cf;function Rf(_,b,R,L,z,Y,se){as=!0,un=dn=xn._x=xn._y=!1,Hh(_,b,R,L,z,Y,se,!0,!1),_!=null&&(Ge(Ud,zd,Pf,!1),Ro(Rg,n,wr,Er,y,U,null));let{left:ce,top:me,width:Ae,height:Re}=Vt;Ef=ce,Tf=me,Af=Ae,Cf=Re}function Pf(_,b,R,L,z,Y,se){as=xn._x=xn._y=!1,Hh(_,b,R,L,z,Y,se,!1,!0);let{left:ce,top:me,width:Ae,height:Re}=Vt,Ne=Ae>0||Re>0,et=Ef!=ce||Tf!=me||Af!=Ae||Cf!=Re;if(Ne&&et&&qa(Vt),xn.setScale&&Ne&&et){let yt=ce,gt=Ae,ct=me,Ze=Re;if(C.ori==1&&(yt=me,gt=Re,ct=ce,Ze=Ae),un&&ls(A,Ai(yt,A),Ai(yt+gt,A)),dn)for(let He in v){let Ht=v[He];He!=A&&Ht.from==null&&Ht.min!=Dt&&ls(He,Ai(ct+Ze,He),Ai(ct,He))}Wh()}else _e.lock&&(_e._lock=!_e._lock,Bs(b,!0,_!=null));_!=null&&(Bt(Ud,zd),Ro(Ud,n,zt,qt,y,U,null))}function U_(_,b,R,L,z,Y,se){if(_e._lock)return;_n(_);let ce=as;if(as){let me=!0,Ae=!0,Re=10,Ne,et;C.ori==0?(Ne=un,et=dn):(Ne=dn,et=un),Ne&&et&&(me=zt<=Re||zt>=y-Re,Ae=qt<=Re||qt>=U-Re),Ne&&me&&(zt=zt<wr?0:y),et&&Ae&&(qt=qt<Er?0:U),Bs(null,!0,!0),as=!1}zt=-10,qt=-10,xe.fill(null),Bs(null,!0,!0),ce&&(as=ce)}function If(_,b,R,L,z,Y,se){_e._lock||(_n(_),Se(),Wh(),_!=null&&Ro(Lg,n,zt,qt,y,U,null))}function Lf(){S.forEach(gT),Ie(n.width,n.height,!0)}gr(vh,go,Lf);let Cr={};Cr.mousedown=Rf,Cr.mousemove=wf,Cr.mouseup=Pf,Cr.dblclick=If,Cr.setSeries=(_,b,R,L)=>{let z=jt.match[2];R=z(n,b,R),R!=-1&&Ti(R,L,!0,!1)},Je&&(Ge(Rg,g,Rf),Ge(Nd,g,wf),Ge(Pg,g,_=>{_n(_),Co(!1)}),Ge(Ig,g,U_),Ge(Lg,g,If),$d.add(n),n.syncRect=Co);let Ya=n.hooks=i.hooks||{};function fn(_,b,R){Oh?Eo.push([_,b,R]):_ in Ya&&Ya[_].forEach(L=>{L.call(null,n,b,R)})}(i.plugins||[]).forEach(_=>{for(let b in _.hooks)Ya[b]=(Ya[b]||[]).concat(_.hooks[b])});let Df=(_,b,R)=>R,jt=en({key:null,setSeries:!1,filters:{pub:Gg,sub:Gg},scales:[A,M[1]?M[1].scale:null],match:[Wg,Wg,Df],values:[null,null]},_e.sync);jt.match.length==2&&jt.match.push(Df),_e.sync=jt;let Nf=jt.key,Xh=z0(Nf);function Ro(_,b,R,L,z,Y,se){jt.filters.pub(_,b,R,L,z,Y,se)&&Xh.pub(_,b,R,L,z,Y,se)}Xh.sub(n);function F_(_,b,R,L,z,Y,se){jt.filters.sub(_,b,R,L,z,Y,se)&&Cr[_](null,b,R,L,z,Y,se)}n.pub=F_;function O_(){Xh.unsub(n),$d.delete(n),Pe.clear(),Gd(vh,go,Lf),l.remove(),ne?.remove(),fn("destroy")}n.destroy=O_;function qh(){fn("init",i,e),fe(e||i.data,!1),X[A]?kh(A,X[A]):Se(),de=Vt.show&&(Vt.width>0||Vt.height>0),B=pe=!0,Ie(i.width,i.height)}return M.forEach(Us),S.forEach(Uh),t?t instanceof HTMLElement?(t.appendChild(l),qh()):t(n,qh):qh(),n}Mn.assign=en;Mn.fmtNum=tf;Mn.rangeNum=yh;Mn.rangeLog=Sh;Mn.rangeAsinh=Qd;Mn.orient=xr;Mn.pxRatio=bt;Mn.join=aE;Mn.fmtDate=sf,Mn.tzDate=xE;Mn.sync=z0;{Mn.addGap=eT,Mn.clipGaps=Th;let i=Mn.paths={points:q0};i.linear=$0,i.stepped=iT,i.bars=sT,i.spline=oT}var Ph=class{constructor(e){this.curves=e;this.columns=Array.from({length:e.length+1},()=>[])}columns;add(e){let t=e.robot_time[0]??0,n=this.columns[0]??[],s=n[n.length-1];typeof s=="number"&&t<s&&this.columns.forEach(r=>r.length=0),typeof s=="number"&&t-s>.3&&this.columns.forEach((r,o)=>r.push(o===0?(s+t)/2:null)),n.push(t);for(let[r,{value:o}]of this.curves.entries()){let a=o(e);this.columns[r+1]?.push(a===void 0||Number.isNaN(a)?null:a)}n.length>3600*1.1&&(this.columns=this.columns.map(r=>r.slice(-3600)))}data(e,t){let n=this.columns[0],s=(n[n.length-1]??0)-t,r=n.findIndex(o=>o>=s);return[0,...e.map(o=>o+1)].map(o=>(this.columns[o]??[]).slice(Math.max(r,0)))}};var _T=200,xT=[10,30,120],vT=["#2f7fd6","#d9822b","#2ba06a","#b04fc4"];function yT({description:i}){let e=(n,s,r)=>({name:r,value:o=>o[n][s]}),t=n=>({name:"°",value:s=>(s.joint[n]??NaN)*180/Math.PI});return[{title:"Speed, m/s and rad/s",curves:[e("velocity",0,"forward"),e("velocity",1,"left"),e("velocity",2,"turn")]},{title:"Load on the feet, N",curves:[e("foot_force",0,"left"),e("foot_force",1,"right")]},{title:"ZMP along x, m from the base",curves:[e("zmp",0,"measured"),e("planned_zmp",0,"planned"),e("com",0,"CoM")]},{title:"ZMP along y, m from the base",curves:[e("zmp",1,"measured"),e("planned_zmp",1,"planned"),e("com",1,"CoM")]},{title:"Height, m",curves:[e("base_height",0,"base"),e("com",2,"CoM")]},{title:"Age at the robot and way there and back, s",curves:[e("age",0,"joints"),e("age",1,"pose"),e("round_trip",0,"way")]},...i.joints.map(({name:n},s)=>({title:`${n.replaceAll("_"," ")}, °`,curves:[t(s)]}))]}var uf=class{constructor(e,t,n,s){this.plots=e;this.histories=t;this.held=s;let r=ee("select",{"aria-label":"What this plot shows"},...e.map(({title:o},a)=>ee("option",{value:a},o)));r.value=String(n),r.addEventListener("change",()=>this.choose(Number(r.value))),this.box.append(r),this.chosen=n}box=ee("figure");plot;chosen=0;choose(e){this.chosen=e,this.makeAnew()}makeAnew(){this.plot?.destroy(),this.plot=void 0}draw(e){let{curves:t}=this.plots[this.chosen],n=this.histories[this.chosen]?.data(t.map((r,o)=>o),e);this.plot??=this.make(t);let s=this.box.clientWidth;s>0&&s!==this.plot.width&&this.plot.setSize({width:s,height:this.plot.height}),this.plot.setData(n,!this.held())}zoom(e){let{min:t=0,max:n=0}=this.plot?.scales.x??{},s=((t??0)+(n??0))/2,r=((n??0)-(t??0))/2*e;this.plot?.setScale("x",{min:s-r,max:s+r})}make(e){let t=getComputedStyle(this.box),n={stroke:t.color,grid:{stroke:t.getPropertyValue("--line"),width:1},ticks:{stroke:t.getPropertyValue("--line"),width:1}};return new Mn({width:Math.max(this.box.clientWidth,200),height:170,cursor:{drag:{x:!0,y:!1}},scales:{x:{time:!1}},axes:[{...n,values:(s,r)=>r.map(o=>`${o} s`)},{...n,size:52}],series:[{label:"s"},...e.map(({name:s},r)=>({label:s,stroke:vT[r]??"#888",width:1.5}))]},[[],...e.map(()=>[])],this.box)}};function j0(i){let e=yT(i),t=e.map(({curves:d})=>new Ph(d)),n=!1,s=!1,r=-1/0,o=[0,1,2].map(d=>new uf(e,t,d,()=>n)),a=ee("select",{"aria-label":"How much time is shown"},...xT.map(d=>ee("option",{value:d},`${d} s`))),c=Rt("Hold",()=>{n=!n,c.setAttribute("aria-pressed",String(n)),c.textContent=n?"Go on":"Hold"},{"aria-pressed":"false"}),l=d=>()=>{n||c.click(),d()},u=ee("div",{class:"tools"},a,c,Rt("Zoom in",l(()=>o.forEach(d=>d.zoom(.5)))),Rt("Zoom out",l(()=>o.forEach(d=>d.zoom(2))))),h=ee("p",{class:"hint"},"Drag over a plot to zoom into it while it is held; a double click shows all again.");return matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>o.forEach(d=>d.makeAnew())),i.frameTakers.push(d=>t.forEach(f=>f.add(d))),{title:"Plots",content:ee("div",{class:"plots"},u,...o.map(({box:d})=>d),h),show:()=>s=!0,hide:()=>s=!1,look:d=>{!s||n||d-r<_T||(r=d,o.forEach(f=>f.draw(Number(a.value))))}}}var Ns=class{list=ee("dl",{class:"facts"});values=new Map;set(e,t,n=!1){let s=this.values.get(e);s||(s=ee("dd"),this.values.set(e,s),this.list.append(ee("div",{},ee("dt",{},e),s))),lt(s,t),s.classList.toggle("bad",n)}};var bT=1e4,MT=1e3;function ST(i,e,t,n){let s=l=>t[l],r=t.live,o=s("names").map((l,u)=>{let h=`parameter-${e}-${l}`,d=ee("input",{id:h,value:s("values")[u]??"",disabled:!r[u],spellcheck:!1,autocomplete:"off"}),f=ee("form",{class:"parameter"},ee("label",{for:h},l),d,ee("button",{type:"submit",disabled:!r[u]},"Set"),ee("small",{},s("docs")[u]??""));return f.addEventListener("submit",g=>{g.preventDefault(),i.attempt(`${e}: ${l} = ${d.value}`,async()=>{i.command.mine||await i.command.take(),await i.robot.order("/plugins/set_parameter",{plugin:e,parameter:l,value:d.value})}).then(n)}),{change:f,live:r[u]??!1}}),a=o.filter(l=>!l.live).map(l=>l.change),c=o.filter(l=>l.live).map(l=>l.change);return ee("div",{},...c,ee("details",{},ee("summary",{},`${a.length} that hold until a restart`),...a))}function wT(i,e,t){let n=e.steps-i.steps,s=n>0?(t-i.seen_s)*1e3/n:NaN;lt(i.state,e.state),i.box.classList.toggle("bad-card",e.state!=="works"),i.facts.set("period",Number.isNaN(s)?"–":`${s.toFixed(1)} ms`),i.facts.set("p50",`${e.p50_step_us.toFixed(0)} µs`),i.facts.set("p99",`${e.p99_step_us.toFixed(0)} µs`),i.facts.set("worst",`${e.worst_step_us.toFixed(0)} µs`),i.facts.set("faults",String(e.faults),e.faults>0),i.facts.set("over budget",String(e.overruns),e.overruns>0)}function Q0(i){let{robot:e,attempt:t,command:n,news:s,freshness:r}=i,o=ee("div"),a=ee("section",{"aria-label":"Parameters",hidden:!0}),c=new Map,l=-1/0,u=async m=>{let p=await e.order("/plugins/get_parameters",{plugin:m},bT);a.hidden=!1,a.replaceChildren(ee("h2",{tabindex:-1},`Parameters of ${m}`),ST(i,m,p,()=>h(m)))},h=m=>void u(m).catch(p=>s.say(p.message,"bad")),d=m=>void u(m).then(()=>a.querySelector("h2")?.focus(),p=>s.say(p.message,"bad")),f=m=>void t(`Reload ${m}`,async()=>{n.mine||await n.take(),await e.order("/plugins/reload",{name:m,library:""},1e4)}),g=({name:m,steps:p},M)=>{let S=ee("span",{class:"plugin-state"}),v=new Ns,P=ee("article",{class:"card","aria-label":m},ee("header",{},ee("h2",{},m),S,Rt("Parameters",()=>d(m),{"aria-label":`Parameters of ${m}`}),Rt("Reload",()=>f(m),{"aria-label":`Reload ${m}`})),v.list);o.append(P);let A={box:P,state:S,facts:v,steps:p,seen_s:M};return c.set(m,A),A},x=async()=>{let{plugins:m}=await e.order("/plugins/list"),p=r.newest?.robot_time[0]??0;for(let M of m){let S=c.get(M.name)??g(M,p);M.steps<S.steps&&Object.assign(S,{steps:M.steps,seen_s:p}),wT(S,M,p)}};return{title:"Plug-ins",content:ee("div",{class:"plugins"},o,a),look:m=>{!e.isOpen||m-l<MT||(l=m,x().catch(p=>s.say(p.message,"bad")))}}}function ET(i){return i<1e6?`${Math.ceil(i/1e3)} kB`:`${(i/1e6).toFixed(1)} MB`}var TT=1e3;function e_({robot:i,attempt:e,news:t}){let n=ee("input",{id:"recording-name",placeholder:"named by the time",pattern:"[A-Za-z0-9_.\\-]*",maxlength:100}),{table:s,body:r}=Pi("Recordings (MCAP), the newest first","file","size","begun"),o=ee("p",{class:"hint path"}),a=new Map,c=-1/0,l=({file:m,bytes:p})=>{let M=a.get(m);return a.set(m,p),`${ET(p)}${M!==void 0&&p>M?", recording":""}`},u=async()=>{c=performance.now();let m=await i.order("/recording/list"),p=m.recordings;r.replaceChildren(...p.map(S=>$a(ee("span",{class:"path",title:S.file},S.file.split("/").pop()??S.file),l(S),new Date(S.start.sec*1e3).toLocaleString())));let M=p[0]?.file.replace(/\/[^/]*$/,"");lt(o,M===void 0?"There are none yet.":`On the robot's computer, in ${M}. ${m.message}`)},h=()=>void u().catch(m=>t.say(m.message,"bad")),d=()=>void e("Recording",()=>i.order("/recording/start",{name:n.value}),"begun").then(h),f=Rt("Record",d),g=Rt("End the recording",()=>void e("Recording",()=>i.order("/recording/stop",{},1e4),"ended").then(h));return n.addEventListener("keydown",m=>m.key==="Enter"&&d()),{title:"Recordings",content:ee("div",{class:"recordings"},ee("div",{class:"tools"},ee("label",{for:"recording-name"},"Name"),n,f,g),s,o),show:h,look:m=>{i.isOpen&&m-c>TT&&u().catch(()=>{})}}}async function n_(i){let e=await fetch("bus.json",Wi(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var AT=2147483648,CT=1073741824,RT=536870912;function PT(i){return`0x${i.toString(16).toUpperCase().padStart(3,"0")}`}function i_(i,e){return i.joint<0?i.kind:`${i.kind}, ${e[i.joint]??`joint ${i.joint}`}`}function IT(i){return`unknown ${(i&AT)!==0?"extended ":""}${(i&CT)!==0?"remote ":""}frame ${PT(i&536870911)}`}var df=class{constructor(e,t,n){this.slot=e;this.table=t;this.frames=n;this.sync=n.find(({message:s})=>s.released==="slot_edge")}sync;ofMissing(e){if(e.released==="slot_edge")return 0;if(e.released==="sync")return this.sync?.end_us??this.table.messages.find(({released:t})=>t==="slot_edge")?.worst_us??void 0}of(e){let{message:t,start_us:n}=e;switch(t.released){case"sync":return this.answersNothingHere(e)?void 0:this.ofMissing(t);case"cycle_edge":return this.slot.slot===0?0:void 0;case"batch":return this.frames.find(s=>s.message.released==="batch"&&t_(s)===t_(e))?.start_us;case"trajectory":return this.frames.findLast(s=>s.message.joint===t.joint&&s.message.released==="cycle_edge"&&s.end_us<=n)?.end_us;default:return this.ofMissing(t)}}answersNothingHere({start_us:e}){return this.sync!==void 0&&e<this.sync.end_us}isOfSlotBefore(e){return e.message.released==="sync"&&this.answersNothingHere(e)&&this.frames.some(t=>t.message===e.message&&t.end_us>e.end_us)}};function t_({message:i,id:e}){return i.ids.indexOf(e)}function LT(i,e,t){let{message:n,end_us:s,start_us:r}=i,o=e.of(i),a=o===void 0||n.worst_us===null?void 0:o+n.worst_us,l=e.isOfSlotBefore(i)||a!==void 0&&s>a?"late":a===void 0?"seen":"in time";return{message:n,name:i_(n,t),verdict:l,end_us:s,length_us:s-r,...o!==void 0&&{due_us:o},...a!==void 0&&{latest_us:a}}}function DT(i,e){return!i.on_event&&i.period_us===e.slot_us&&(i.released==="slot_edge"||i.released==="sync")}function s_(i,e,t){let n=new Map(e.messages.flatMap(h=>h.ids.map(d=>[d,h]))),s=[],r=[],o=0;for(let[h,d]of i.id.entries()){let[f,g]=[i.end_us[h]??0,i.length_us[h]??0],x=n.get(d);if((d&RT)!==0){s.push({name:"error on the bus",verdict:"error",end_us:f,length_us:0});continue}o+=Math.min(g,f)+e.interframe_us,x?r.push({message:x,id:d,start_us:f-g,end_us:f}):s.push({name:IT(d),verdict:"foreign",end_us:f,length_us:g})}r.sort((h,d)=>h.end_us-d.end_us);let a=new df(i,e,r);s.push(...r.map(h=>LT(h,a,t)));let c=new Set(r.filter(h=>!a.isOfSlotBefore(h)).map(({message:h})=>h));for(let h of i.left_out>0?[]:e.messages){let d=a.ofMissing(h);c.has(h)||d===void 0||!DT(h,e)||s.push({message:h,name:i_(h,t),verdict:"missing",length_us:h.transmission_us,due_us:d,...h.worst_us!==null&&{latest_us:d+h.worst_us}})}let l=({end_us:h,due_us:d})=>h??d??0;s.sort((h,d)=>l(h)-l(d));let u={"in time":0,seen:0,late:0,missing:0,foreign:0,error:0};for(let{verdict:h}of s)u[h]+=1;return{entries:s,load:Math.min(o/e.slot_us,1),count:u}}function ff({entries:i,load:e}){return`${i.filter(({end_us:n,verdict:s})=>n!==void 0&&s!=="error").length} frames take ${Math.round(e*100)} % of the slot`}function pf({entries:i,count:e}){let t=s=>{let r=i.filter(o=>o.verdict===s).map(({name:o})=>o);return r.length>2?`${r.slice(0,2).join("; ")} …`:r.join("; ")},n=[e.missing>0&&`${e.missing} missing (${t("missing")})`,e.late>0&&`${e.late} late (${t("late")})`,e.error>0&&`${e.error} ${e.error===1?"error":"errors"}`,e.foreign>0&&`${e.foreign} not the robot's own (${t("foreign")})`].filter(s=>s!==!1);return n.length>0?n.join(", "):"none is missing or late"}var r_=({count:i})=>i.missing+i.late+i.error+i.foreign>0;var Qn=14,NT=18,UT=5.7,o_=22,FT=12,OT=280,kT=2e3,a_=1500,BT={SYNC:"sync",trim:"trim",feedback:"feedback",trajectory:"trajectory"},zT=[["sync","SYNC"],["trim","trim"],["feedback","feedback"],["trajectory","trajectory"],["other","other"],["due","due"],["latest","proven latest"],["late","late"],["missing","missing"],["error","error"],["foreign","foreign"]];function hi(i,e,t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,typeof r=="number"?String(Math.round(r*10)/10):r);return t!==void 0&&(n.textContent=t),n}var Ih=i=>i===void 0?"–":(i/1e3).toFixed(2);function VT({name:i,verdict:e,end_us:t,length_us:n,latest_us:s}){let r=t===void 0?"has not come":`at ${Ih(t)} ms`;return[`${i}: ${r}`,n>0&&t!==void 0&&`${n} µs long`,s!==void 0&&`at the latest ${Ih(s)} ms`,e!=="seen"&&e].filter(Boolean).join(", ")}var Lh=class{constructor(e,t){this.bus=e;this.joints=t;let n=[...new Set(e.messages.map(({joint:a})=>a).filter(a=>a>=0))].sort((a,c)=>a-c);for(let[a,c]of n.entries())this.jointLane.set(c,a+1);this.lanes=["all joints",...n.map(a=>t[a]??""),"others, errors"].map(a=>a.length>o_?`${a.slice(0,o_-1)}…`:a),this.label_px=Math.max(...this.lanes.map(({length:a})=>a))*UT+10;let{table:s,body:r}=Pi("Frames of the slot; times in ms from its edge","frame","end","µs","at the latest","");s.classList.add("bus-table"),this.rows=r,this.details=ee("details",{},ee("summary",{},"The slot as a table"),s),this.details.addEventListener("toggle",()=>this.fillTable()),this.box.append(this.drawing);let o=ee("ul",{class:"bus-legend","aria-hidden":!0},...zT.map(([a,c])=>ee("li",{class:a},c)));this.content=ee("div",{},ee("div",{class:"tools"},this.hold,this.status),this.box,this.verdict,o,ee("p",{class:"note"},this.note()),this.details),new ResizeObserver(()=>this.draw()).observe(this.box)}drawing=hi("svg",{role:"img"});status=ee("p",{class:"bus-status"});verdict=ee("p",{class:"bus-verdict"});hold=Rt("Hold",()=>this.toggle());rows;details;lanes;label_px;jointLane=new Map;box=ee("div",{class:"bus-picture"});shown;slot;held=!1;content;take(e){this.held||(this.slot=e,this.shown=s_(e,this.bus,this.joints),lt(this.verdict,pf(this.shown)),this.verdict.classList.toggle("bad",r_(this.shown)),this.draw(),this.fillTable())}look(e,t){if(!this.slot||!this.shown){lt(this.status,"No slot has come yet.");return}let{sec:n,nanosec:s}=this.slot.header.stamp,r=e-n*1e3-s/1e6,o=r<-a_?NaN:Math.max(r,0),a=!t||Number.isNaN(o)||o>a_;this.box.classList.toggle("old",a&&!this.held);let c=this.held?"held, ":a?"old: ":"";lt(this.status,`Slot ${this.slot.slot} of cycle ${this.slot.cycle}, ${c}${Number.isNaN(o)?"of unknown age":`${ii(o)} ago`}. ${ff(this.shown)}.`)}note(){let{profile:e,load:t,jitter_us:n,jam_us:s}=this.bus;return`One slot of 25. Proven for the profile '${e}': load ${Math.round(t*100)} % at most; latest arrivals with senders up to ${n/1e3} ms late and the bus jammed once for ${s/1e3} ms.`}toggle(){this.held=!this.held,this.hold.setAttribute("aria-pressed",String(this.held))}laneOf({message:e}){return e?e.joint<0?0:this.jointLane.get(e.joint)??this.lanes.length-1:this.lanes.length-1}draw(){let e=Math.max(this.box.clientWidth,OT);if(!this.shown||this.box.clientWidth===0)return;let t=this.lanes.length*Qn+NT,{slot_us:n}=this.bus,s=r=>this.label_px+Math.min(Math.max(r,0),n)/n*(e-this.label_px-FT);this.drawing.setAttribute("viewBox",`0 0 ${e} ${t}`),this.drawing.setAttribute("height",String(t)),this.drawing.setAttribute("aria-label",`${ff(this.shown)}: ${pf(this.shown)}`),this.drawing.replaceChildren(...this.ground(s,e),...this.dueLine(s),...this.shown.entries.flatMap(r=>this.marks(r,s)))}ground(e,t){let n=this.lanes.length*Qn,s=this.lanes.flatMap((r,o)=>[hi("rect",{class:o%2===0?"lane even":"lane",x:0,y:o*Qn,width:t,height:Qn}),hi("text",{x:this.label_px-6,y:(o+1)*Qn-3.5,"text-anchor":"end"},r)]);for(let r=0;r<=this.bus.slot_us;r+=kT)s.push(hi("line",{class:"grid",x1:e(r),x2:e(r),y1:0,y2:n}),hi("text",{x:r===this.bus.slot_us?t:e(r),y:n+13,"text-anchor":r===this.bus.slot_us?"end":"middle"},`${r/1e3}${r===this.bus.slot_us?" ms":""}`));return s}dueLine(e){let t=this.shown?.entries.find(({message:n,due_us:s})=>n?.released==="sync"&&s!==void 0)?.due_us;return t===void 0?[]:[hi("line",{class:"due",x1:e(t),x2:e(t),y1:Qn,y2:(this.lanes.length-1)*Qn})]}marks(e,t){let{message:n,verdict:s,end_us:r,length_us:o,due_us:a,latest_us:c}=e,l=this.laneOf(e)*Qn,u=[];return c!==void 0&&c<=this.bus.slot_us&&u.push(hi("line",{class:"latest",x1:t(c),x2:t(c),y1:l+1,y2:l+Qn-1})),r===void 0?u.push(hi("text",{class:"missing",x:t(a??0)+4,y:l+Qn-3.5},"✕ missing")):s==="error"?u.push(hi("text",{class:"error",x:t(r),y:l+Qn-3,"text-anchor":"middle"},"◆")):u.push(...this.block(t(r-o),t(r),l,s,n)),u.at(-1)?.append(hi("title",{},VT(e))),u}block(e,t,n,s,r){let o=s==="foreign"?"foreign":BT[r?.kind??""]??"other",a=hi("rect",{class:`frame ${o}${s==="late"?" late":""}`,x:e,y:n+2,width:Math.max(t-e,1.5),height:Qn-4});return s!=="late"?[a]:[hi("text",{class:"late",x:e-2,y:n+Qn-3.5,"text-anchor":"end"},"late"),a]}fillTable(){!this.details.open||!this.shown||this.rows.replaceChildren(...this.shown.entries.map(e=>{let{name:t,end_us:n,length_us:s,latest_us:r,verdict:o}=e,a=$a(t,Ih(n),n===void 0?"–":String(s),Ih(r),o);for(let c of[1,2,3])a.cells[c]?.classList.add("number");return a.classList.toggle("bad",o!=="in time"&&o!=="seen"),a}))}};async function l_(i){let e=await fetch("calibration.json",Wi(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var Dh=i=>i*180/Math.PI,HT=(i,e)=>(i<0?"−":"+")+Math.abs(i).toFixed(e),GT="as described";function mf(i,e,t,n){if(!i)return GT;let s=i.deviation?.[e];return HT(t(i.value[e]??NaN),n)+(s===void 0?"":` ± ${t(s).toFixed(n)}`)}var c_=i=>mf(i,0,Dh,3),h_=(i,e)=>mf(i,e,t=>t*1e3,1),u_=(i,e)=>mf(i,e,t=>t,3).replace(/^\+/,"");function d_([i,e,t,n]){let s=2*(n*e-t*i),r=Math.abs(s)>1-1e-9,o=r?0:Math.atan2(2*(n*i+e*t),1-2*(i*i+e*e)),a=Math.asin(Math.min(1,Math.max(-1,s))),c=r?-2*Math.sign(s)*Math.atan2(i,n):Math.atan2(2*(n*t+i*e),1-2*(e*e+t*t));return[Dh(o),Dh(a),Dh(c)].map(l=>Math.abs(l)<5e-4?0:l)}function f_({there:i,made:e}){return i?e===null?"Calibrated; its file does not say when.":`Calibrated, made ${e.replace("T"," ").replace(/:\d\dZ$/," UTC")}.`:"This robot has no calibration: zeros, centre of mass and gains are taken to be as its description says. gaitway calibrate finds them."}var WT=["front left","front right","rear left","rear right"],gf=i=>ee("th",{scope:"row"},i),za=i=>ee("td",{class:"number"},i);function XT({joints:i}){let{table:e,body:t}=Pi("Joint zeros: what an encoder says where its joint is at 0","joint","zero, °","trim channel");e.classList.add("zeros");for(let{name:n,zero:s,trim_channel:r}of i)t.append(ee("tr",{},gf(n.replaceAll("_"," ")),za(c_(s)),za(r===null?"–":String(r))));return e}function qT({feet:i}){if(i.every(({sensor:n})=>n!=="cells"))return ee("p",{class:"hint"},"Its feet have no force cells.");let{table:e,body:t}=Pi("Force cells: reading over force; each is taken to read 0 N without load","cell","left","right");e.classList.add("gains");for(let[n,s]of WT.entries())t.append(ee("tr",{},gf(s),...i.map(({gain:r,sensor:o})=>za(o==="cells"?u_(r,n):"–"))));return e}function YT({trunk_com_offset:i,imu:e}){let{table:t,body:n}=Pi(`Trunk and IMU (in ${e.link})`,"axis","centre of mass off by, mm","IMU turned by, °");t.classList.add("trunk");let s=d_(e.turn);for(let[r,o]of["x, roll","y, pitch","z, yaw"].entries())n.append(ee("tr",{},gf(o),za(h_(i,r)),za((s[r]??NaN).toFixed(2))));return t}function p_({token:i,news:e}){let t=ee("div"),n=ee("details",{class:"calibration"},ee("summary",{},"Calibration"),t),s=!1;return n.addEventListener("toggle",()=>{!n.open||s||(s=!0,l_(i()).then(r=>t.replaceChildren(ee("p",{},f_(r)),XT(r),qT(r),YT(r)),r=>{s=!1,n.open=!1,e.say(`The calibration does not come: ${r.message}`,"bad")}))}),n}function $T(i){let{table:e,body:t}=Pi("Joints","joint","position, °","torque, N·m","faults");e.classList.add("joints");let n=i.description.joints.map(({name:s})=>{let[r,o]=[ee("td",{class:"number"}),ee("td",{class:"number"})],a=ee("td"),c=ee("tr",{},ee("th",{scope:"row"},s.replaceAll("_"," ")),r,o,a);return t.append(c),{row:c,position:r,torque:o,faults:a}});return{table:e,joints:n}}function ZT({freshness:i},e,t,n,s){let r=i.newest;if(!r)return;n.set("late",String(r.batches_late[0]),(r.batches_late[0]??0)>0),n.set("refused",String(r.batches_refused[0]),(r.batches_refused[0]??0)>0),n.set("cycles from a safe tail",String(r.tails_played[0])),n.set("robot's clock",`${(r.robot_time[0]??0).toFixed(1)} s`);for(let[l,u]of tl.entries()){let h=i.age_ms(l,t);s.set(u,ii(h),l!==3&&h>300)}s.set("way there and back",Number.isNaN(r.round_trip[0])?"–":ii((r.round_trip[0]??0)*1e3));let{frames:o,outages:a,longest_ms:c}=i.loss;s.set("lost by this page",`${o} frames, ${a} outages${a>0?`, the longest ${ii(c)}`:""}`,a>0),s.set("pictures",`${e.pace.perSecond} /s, ${e.pace.total} in all`)}function KT(i){let{robot:e,freshness:t,description:n}=i,s=ee("div",{},ee("p",{class:"note"},"The robot is asked what its bus is meant to carry.")),r,o,a=async()=>{try{r=new Lh(await n_(i.token()),n.joints.map(({name:c})=>c.replaceAll("_"," "))),s.replaceChildren(r.content)}catch(c){s.replaceChildren(ee("p",{class:"note bad"},`What the bus is meant to carry does not come: ${c.message}`)),o=void 0}};return{content:s,show:()=>{let[c,l]=[!0,()=>{}];return o??=a(),o.then(()=>{r&&c&&(l=e.subscribe("/bus_slot","gaitway_msgs/msg/BusSlot",0,u=>r?.take(u)))}),()=>{c=!1,l()}},look:c=>r?.look((t.newest?.robot_time[0]??NaN)*1e3+t.age_ms(4,c),t.state(c)==="live")}}function m_(i,e){let{robot:t,freshness:n,description:s}=i,[r,o,a]=[new Ns,new Ns,new Ns],c=KT(i),{table:l,joints:u}=$T(i),h=ee("div",{class:"state"},ee("h2",{},"Batches"),r.list,ee("h2",{},"Age of what is shown"),o.list,ee("h2",{},"Bus"),a.list,ee("h2",{},"A time slot on the bus"),c.content,l,p_(i)),d=new Map,f=[],g=m=>{for(let[p,M]of m.effort.entries()){let S=Math.abs(M)/(s.joints[p]?.torque??1/0),v=u[p]?.torque;v&&(lt(v,M.toFixed(2)),v.classList.toggle("bad",S>.95))}},x=m=>{let p=m.status;d=new Map(p.find(({name:P})=>P==="nodes")?.values.map(({key:P,value:A})=>[P,A]));let{message:M="",level:S=0,values:v=[]}=p.find(({name:P})=>P==="bus")??{};a.set("state",M,S>0);for(let{key:P,value:A}of v)(A!=="0"||P.endsWith("_errors"))&&a.set(P.replaceAll("_"," "),A)};return{title:"State",content:h,show:()=>{f=[t.subscribe("/joint_states","sensor_msgs/msg/JointState",250,g),t.subscribe("/diagnostics","diagnostic_msgs/msg/DiagnosticArray",0,x),c.show()]},hide:()=>f.forEach(m=>m()),look:m=>{ZT(i,e,m,r,o),c.look(m);for(let[p,M]of u.entries()){let S=n.newest?.joint[p];lt(M.position,S===void 0?"–":(S*180/Math.PI).toFixed(1));let v=n.newest!==void 0&&jf(n.newest,p);lt(M.faults,v?d.get(s.joints[p]?.name??"")??"fault":""),M.row.classList.toggle("bad",v)}}}}function g_(i){let e=_t("token"),t=_t("token-text");return lt(_t("token-why"),i),t.value="",new Promise(n=>{e.oncancel=s=>s.preventDefault(),e.onclose=()=>{t.value===""?e.showModal():n(t.value.trim())},e.showModal(),t.focus()})}var Va="75e35916ff12dffc";async function __(){let i=await fetch("version.json",{cache:"no-store",signal:AbortSignal.timeout(2e3)});if(i.status===404)return"";if(!i.ok)throw new Error(await i.text());return String((await i.json()).page??"")}function x_(i){let e=i===""?"an older page, without a version":`page ${i}`;return`This page is of another version than the robot's software: this is page ${Va}, the robot has ${e}. It is not understood any more: load the page again. Stop still works.`}var JT="the token is wrong",Nh=class{constructor(e,t,n){this.freshness=t;this.token=n;this.keeper=new Rr(`${e}?page=${Va}`,this)}keeper;since_ms=performance.now();open=!1;onFrame=()=>{};onWrongToken=()=>{};onWrongVersion=()=>{};start(){this.keeper.start(),setInterval(()=>this.look(),1e3/4)}opened(e){this.open=!0,this.since_ms=performance.now();let t=this.token();t!==void 0&&e.send(t)}closed(e){this.open||this.askForVersion(),this.open=!1,e===JT&&(this.keeper.stop(),this.onWrongToken()),this.freshness.disconnected(performance.now())}received(e){try{let t=Kf(e);this.keeper.send(Jf(t)),this.since_ms=performance.now(),this.freshness.take(t,this.since_ms),this.onFrame(t)}catch(t){if(!(t instanceof Do))throw t;this.endFor(`${t.message}: load the page again. Stop still works.`)}}async askForVersion(){let e=await __().catch(()=>Va);e!==Va&&this.endFor(x_(e))}endFor(e){this.keeper.stop(),this.onWrongVersion(e)}look(){this.open&&performance.now()-this.since_ms>1e3&&this.keeper.restart("nothing came")}};var jT=100,QT=500,vr;async function e1(i){for(;;)try{return await Hf(vr)}catch(e){if(e instanceof Io){vr=await g_(vr===void 0?"Whoever serves it can tell you.":"That was not the right one.");continue}i.say(`The robot's description does not come: ${e.message}`,"bad"),await new Promise(t=>setTimeout(t,QT))}}function t1(i){return async(e,t,n="done")=>{try{return await t(),i.say(`${e}: ${n}`,"good",e),!0}catch(s){let r=s instanceof Vs?" Look whether it was carried out: it is not sent again.":"";return i.say(`${e}: ${s.message}${r}`,"bad",e),!1}}}function n1(i,e,t,n,s){let{freshness:r,robot:o,news:a}=i,c=new Nh(Yh("/view"),r,()=>vr),l=new hh(i),u=new dh(_t("tabs"),_t("panels"),s);i.frameTakers.push(f=>t.show(f),f=>n.show(f)),c.onFrame=f=>i.frameTakers.forEach(g=>g(f));let h=new sl(o);c.onWrongVersion=f=>{e.retire();for(let g of["top","camera","panel"])_t(g).inert=!0;h.otherVersion(f)},c.onWrongToken=()=>location.reload(),o.onClose=()=>e.lost(),o.onStatus=(f,g)=>{if(f==="error"&&zf(g)){e.late(performance.now());return}f==="error"&&i.drive.end(),!Vf(g)&&a.say(f==="error"?`What you asked for was not done: ${g}`:g,f==="error"?"bad":"plain")},setInterval(()=>{let f=performance.now();l.look(f),h.look(f),u.look(f),t.setOld(r.state(f)!=="live")},jT),c.start(),o.start()}async function i1(){let i=new rl(_t("news")),e=await e1(i),t=_t("scene"),n=new ch(t,e);n.onDrawn=()=>{performance.getEntriesByName("first-picture").length===0&&performance.mark("first-picture")};let s=new Za(Yh("/"),()=>vr),r=`page ${crypto.getRandomValues(new Uint16Array(1))[0]?.toString(16).padStart(4,"0")}`,o={description:e,freshness:new il,robot:s,command:new Ka(s,r),drive:new Ja,news:i,token:()=>vr,frameTakers:[],attempt:t1(i)},a=new nl(o),c=new uh(o,()=>a.end());a.pad.onStop=()=>c.stop();let{push:l}=e.bounds;Ff(_t("camera"),n,l&&new ol(o,n,t,l));let u=[Mg(o,a),m_(o,n),j0(o),Eg(o),Q0(o),e_(o)];n1(o,a,n,c,u),await n.body.loadMeshes(vr,()=>n.ask())}i1();})();
